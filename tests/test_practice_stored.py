"""The stored gains and draws come out again."""

import control
import joblib
import numpy as np
import pytest

from rlswaim.practice import designs, monte_carlo, synthesis
from rlswaim.practice.hardware import closed_loop, plant
from rlswaim.practice.margins import frequency_response
from rlswaim.practice.structures import STRUCTURES
from rlswaim.source.tables import constants


def test_stored_gains_cost_what_the_table_says():
    found = designs.synthesized()
    assert set(found) == set(STRUCTURES)
    for structure, row in found.items():
        problem = synthesis.Sought(structure)
        gains = {name: row[name] for name in [*problem.sought, *STRUCTURES[structure].fixed]}
        assert problem.of(gains) == pytest.approx(row["cost"], rel=1e-3)
        ways = {name: v for name, v in row.items() if name.startswith(("evolution", "adaptation"))}
        assert len(ways) >= len(synthesis.SEEDS)
        assert row["cost"] == pytest.approx(min(ways.values()), rel=1e-3)
        place = problem.place(gains)
        assert place.min() >= -1e-9
        assert place.max() <= 1 + 1e-9
        assert problem.rounded(place) == pytest.approx(gains, rel=1e-3, abs=1)


@pytest.mark.parametrize("structure", STRUCTURES)
@pytest.mark.parametrize("opened", [None, "delta_c", "delta_r_c"])
def test_quick_loop_is_the_loop(structure, opened):
    kind, gains = STRUCTURES[structure], designs.synthesized()[structure]
    eqs = synthesis.worst_cases()[1]
    whole, made = plant(eqs, kind.instruments(gains), jet=gains["jet"]), kind.controller(gains)
    omega = np.geomspace(0.05, 30, 20)
    ours, theirs = (
        frequency_response(way(whole, made, opened), omega) for way in (synthesis.joined, closed_loop)
    )
    assert np.allclose(ours, theirs, rtol=1e-7, atol=1e-9 * np.abs(theirs).max())


def test_blended_gyros_are_their_transfer_functions():
    gains = designs.synthesized()["blended gyros, notches, nose jet"]
    made = STRUCTURES["blended gyros, notches, nose jet"].controller(gains)
    zeta = constants("ladder")["filter_zeta"]

    def notch(s, name):
        w, zeros, poles = gains[name], gains[f"{name}_zeros"], gains[f"{name}_poles"]
        return (s * s + 2 * zeros * w * s + w * w) / (s * s + 2 * poles * w * s + w * w)

    for s in (0.1j, 1j, 2 + 5j):
        w = gains["low_pass"]
        engine = gains["K_A"] * (1 + gains["K_I"] / s) * notch(s, "notch")
        engine *= w**2 / (s * s + 2 * zeta * w * s + w * w)
        jet = gains["K_J"] * notch(s, "notch_jet") * gains["K_r"] / (s + gains["K_r"])
        for row, (size, blend, K) in enumerate(
            ((engine, gains["blend"], gains["K_R"]), (jet, gains["blend_jet"], gains["K_RJ"]))
        ):
            wanted = size * np.array([1, -blend, -blend * K, blend - 1, (blend - 1) * K])
            assert np.allclose(made(s)[row], wanted, rtol=1e-8)


def test_controller_with_a_direct_way_is_refused():
    made = control.ss([], np.zeros((0, 3)), np.zeros((1, 0)), np.ones((1, 3)))
    with pytest.raises(ValueError, match="made in joined: got a direct way"):
        synthesis.joined(made, made)


def test_draws_run_where_the_configuration_says(capsys):
    monte_carlo.main(2)
    serial = capsys.readouterr()
    with joblib.parallel_config(n_jobs=2, verbose=1):
        monte_carlo.main(2)
    spread = capsys.readouterr()
    assert "with 2 concurrent workers" in spread.err
    assert "concurrent workers" not in serial.err
    assert "draws,2,1" in serial.out
    assert spread.out == serial.out


def test_stored_draws_come_out_again():
    rows = [monte_carlo.one_draw(index) for index in range(monte_carlo.FIRST)]
    stored = monte_carlo.spreads()
    assert set(stored) == set(designs.designs())
    for name, table in stored.items():
        again = monte_carlo.spread([row[name] for row in rows])
        assert again.first == pytest.approx(table.first, rel=2e-3, abs=1e-6)
        assert table.draws >= 2000
        low, high = table.share()
        assert low <= table.stable / table.draws <= high
