"""The exact forms that Python sends to the browser are those of the library's closed loop."""

import math

import numpy as np
import pytest

import rlswaim as rl
from browser_maths import EQS, EQUATIONS, forms, sections, sizes
from rlswaim.explorers.system_views import VIEWS
from rlswaim.loops.given_shapes import with_shapes
from rlswaim.loops.multiaffine import multiaffine_forms
from rlswaim.rootlocus.exact_polynomials import characteristic_polynomial


def random_factors(section: str, seed: int) -> dict[str, float]:
    rng = np.random.default_rng(seed)
    names = forms(section).polynomial.factors
    values = {name: float(rng.choice([-1, 1]) * 10 ** rng.uniform(-2, 2)) for name in names}
    return values | ({"arm": 12.5 * (1 + seed)} if "arm" in values else {})


class TestForms:
    @sections
    @pytest.mark.parametrize("equations", EQUATIONS)
    def test_polynomial_and_numerators_are_those_of_the_closed_loop(self, section, equations):
        found, system = forms(section, equations), VIEWS[section].system
        for seed in range(4):
            values = random_factors(section, seed)
            loop = system.at_factors(EQUATIONS[equations], **values)
            exact = characteristic_polynomial(loop.A)
            scale = sizes(found.polynomial, values)
            assert (abs(found.polynomial(**values) - exact) <= 1e-13 * scale).all()
            for name, by_output in found.numerators.items():
                initial = np.array([[float(label == f"x_{name[:-3]}")] for label in loop.state_labels])
                B = initial if name.endswith("(0)") else loop.B[:, [loop.input_labels.index(name)]]
                for output, form in by_output.items():
                    C = loop.C[[loop.output_labels.index(output)]]
                    exact = characteristic_polynomial(loop.A, B, C)
                    ours = form(**values)
                    assert not exact[ours.size :].any()
                    assert (abs(ours - exact[: ours.size]) <= 1e-13 * sizes(form, values)).all()

    def test_terms_are_those_of_eq_83(self):
        loop = ("K_A", "K_C")
        assert [term.factors for term in forms("IV").polynomial.terms] == [
            (),
            ("K_C",),
            loop,
            (*loop, "K_R"),
            (*loop, "sigma_1"),
            (*loop, "sigma_2"),
            (*loop, "K_R", "sigma_1"),
            (*loop, "K_R", "sigma_2"),
        ]

    def test_a_square_is_found_out(self):
        def squared(K_A: float):
            return rl.rate_attitude(EQS, K_A=K_A, K_C=K_A, K_R=1.0, gyro=None)

        with pytest.raises(ValueError, match="not multi-affine in K_A"):
            multiaffine_forms(squared, [("K_A",)])

    def test_factors_of_two_groups_in_one_entry_are_found_out(self):
        def closed_loop(K_A: float, K_C: float):
            return rl.rate_attitude(EQS, K_A=K_A, K_C=K_C, K_R=1.0, gyro=None)

        assert multiaffine_forms(closed_loop, [("K_A", "K_C")]).polynomial.terms
        with pytest.raises(ValueError, match="not multi-affine in K_A, K_C"):
            multiaffine_forms(closed_loop, [("K_A",), ("K_C",)])

    def test_unknown_and_bad_factors(self):
        form = forms("IV").polynomial
        values = dict.fromkeys(form.factors, 1.0)
        with pytest.raises(ValueError, match="unknown factor 'K_B', wanted K_A, K_C"):
            form(**values, K_B=1.0)
        with pytest.raises(ValueError, match="K_R in MultiAffine: got nan, wanted a finite number"):
            form(**{**values, "K_R": math.nan})

    def test_given_shapes_stand_at_their_stations_alone(self):
        here = with_shapes(EQS, deflections={140.0: (1.5, 2.5)}, slopes={60.0: (0.1, 0.2)})
        assert [mode.deflection(140.0) for mode in here.modes] == [1.5, 2.5]
        assert [mode.slope(60.0) for mode in here.modes] == [0.1, 0.2]
        assert [mode.slope(140.0) for mode in here.modes] == [mode.slope(140.0) for mode in EQS.modes]
