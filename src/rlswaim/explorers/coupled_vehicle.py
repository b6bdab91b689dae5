"""The live view of Section III: how the air couples the rigid body and the bending modes, without control.

The determinant of Eq. 29 is a sum of products of its coefficients, and each
coefficient a sum of products of the parameters and of the mode shapes at both
surfaces.  Python sends both tables, the browser multiplies out.
"""

from functools import partial

import control
import numpy as np

from rlswaim.explorers.bench import coupled_bench
from rlswaim.explorers.coupling_tables import BLOCKS, coupled_products, determinant_table
from rlswaim.explorers.live_view import LiveView
from rlswaim.explorers.parameter import FEET, Value
from rlswaim.explorers.still import Drawing
from rlswaim.explorers.vehicle_parameters import own_values, parameters
from rlswaim.figures.loci import draw_pole_paths
from rlswaim.figures.style import COLORS
from rlswaim.rootlocus.locus import parameter_locus
from rlswaim.vehicle.booster import Booster
from rlswaim.vehicle.equations import perturbation_equations
from rlswaim.vehicle.other_data import with_data

COLORS_OF = {"attitude": "neutral", "short period": "rigid", "mode 1": "mode 1", "mode 2": "mode 2"}


def vehicle(
    booster: Booster, *, omega_1: float, omega_2: float, q_D: float, **surfaces: float
) -> control.StateSpace:
    """Return the uncontrolled vehicle with other frequencies (rad/s), q_D (lb/ft^2) and surfaces.

    Parameters
    ----------
    booster : Booster
    omega_1, omega_2, q_D : float
    **surfaces : float
        C_<name> (1/rad) and l_<name> (ft) of each surface.

    Returns
    -------
    control.StateSpace
    """
    data = {"omega_1": omega_1, "omega_2": omega_2, "q_D": q_D, **surfaces}
    return perturbation_equations(with_data(booster, **data)).state_space()


def cure_presets(booster: Booster) -> list[dict]:
    """Return the vehicle as it is and the three cures of conclusion 2 as values of the sliders."""
    own = own_values(booster)
    payload, fins = (s.name for s in booster.surfaces)
    nodes = [round(x) for x in booster.modes[0].shape.roots(extrapolate=False)]
    moved: dict[str, Value] = {f"l_{payload}": nodes[0], f"l_{fins}": nodes[-1]}
    halved: dict[str, Value] = {f"C_{s.name}": s.C_Nalpha / 2 for s in booster.surfaces[:1]}
    stiffer: dict[str, Value] = {f"omega_{i}": 5 * m.omega for i, m in enumerate(booster.modes, start=1)}
    both: dict[str, Value] = halved | {
        f"omega_{i}": 2 * m.omega for i, m in enumerate(booster.modes, start=1)
    }
    cases = [
        ("As it is", "the report's vehicle", {}),
        (
            "Cure 1: move the surfaces",
            f"both to nodes of the first mode, {nodes[0]} and {nodes[-1]} ft",
            moved,
        ),
        ("Cure 2: less surface", "half the payload's", halved),
        ("Cure 3: stiffer", "both frequencies five times as high", stiffer),
        ("Cures 2 and 3 together", "half the payload's surface, both frequencies doubled", both),
    ]
    return [{"name": n, "label": label, "values": {**own, **change}} for n, label, change in cases]


class CoupledVehicle(LiveView):
    """The uncontrolled vehicle under sliders; ``vehicle()`` is its state space, ``poles()`` its poles."""

    view, system = "coupled-vehicle", "coupling"

    def __init__(self, booster: Booster, **values: Value) -> None:
        self._booster, feet = booster, np.array(FEET, float)
        shapes = {"arm": feet - booster.l_CG}
        for i, mode in enumerate(booster.modes, start=1):
            shapes |= {f"phi_{i}": mode.deflection(feet), f"sigma_{i}": mode.slope(feet)}
        tables = {name: determinant_table(rows, booster.flight.U) for name, rows in BLOCKS.items()}
        payload = {
            "shapes": {name: values.tolist() for name, values in shapes.items()},
            "surfaces": [s.name for s in booster.surfaces],
            "coefficients": coupled_products(booster),
            "determinant": determinant_table(range(4), booster.flight.U),
            "blocks": tables,
            "colors": {name: COLORS[color] for name, color in COLORS_OF.items()},
            "presets": cure_presets(booster),
            "bench": coupled_bench(booster),
        }
        super().__init__(
            parameters(booster), payload, {**own_values(booster), "running": "coupling", **values}
        )

    def drawings(self) -> list[Drawing]:
        """Return the paths of the poles as q_D rises from nothing to its value."""
        locus = parameter_locus(lambda q_D: self._varied(q_D=q_D), np.linspace(0, float(self.q_D), 101))
        return [partial(draw_pole_paths, locus=locus, parameter="$q_D$")]

    def _varied(self, **changes: float) -> control.StateSpace:
        own = {name: float(value) for name, value in self.values().items() if name != "running"}
        return vehicle(self._booster, **{**own, **changes})

    def vehicle(self) -> control.StateSpace:
        """Return the uncontrolled vehicle under the sliders."""
        return self._varied()

    def poles(self) -> np.ndarray:
        """Return the vehicle's poles under the sliders (1/s)."""
        return self.vehicle().poles()


def coupled_vehicle_explorer(booster: Booster, **values: Value) -> CoupledVehicle:
    """Return the live view of the vehicle without control.

    Parameters
    ----------
    booster : Booster
    **values : float or str
        Where the sliders start: omega_1, omega_2 (rad/s), q_D (lb/ft^2), C_payload, C_fins (1/rad),
        l_payload, l_fins (ft, whole), running ("coupling" or one of the others: what runs along the paths).

    Returns
    -------
    CoupledVehicle

    Raises
    ------
    ValueError
        If a value is not finite or out of range.
    TypeError
        If a value is not of its kind or a parameter is unknown.

    Notes
    -----
    Eqs. 29 and 39 to 54, conclusion 2.
    """
    return CoupledVehicle(booster, **values)
