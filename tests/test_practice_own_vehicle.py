"""A reader's own vehicle from a CSV file: the report's written out and read again, and what is refused."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import rlswaim as rl
from rlswaim import explorers

EXAMPLE = Path(rl.__file__).parent / "source/data/example_vehicle.csv"
LINES = EXAMPLE.read_text(encoding="utf-8").splitlines()


def written(booster, path):
    """Write a booster as a file of its own."""
    rows = [("mass", "", x, m) for x, m in zip(booster.stations, booster.masses, strict=True)]
    rows += [("surface", s.name, s.station, s.C_Nalpha) for s in booster.surfaces]
    for name, mode in zip("ab", booster.modes, strict=True):
        rows += [("deflection", name, *at) for at in zip(mode.stations, mode.deflections, strict=True)]
        rows += [("slope", name, *at) for at in zip(mode.slope_stations, mode.slopes, strict=True)]
        rows += [("frequency", name, "", mode.omega), ("damping", name, "", mode.zeta)]
    rows += [("vehicle", "S", "", booster.S), ("vehicle", "T", "", booster.T)]
    rows += [("vehicle", "thrust_station", "", booster.thrust_station)]
    rows += [
        ("flight", name, "", getattr(booster.flight, name)) for name in ("q_D", "U", "h", "t", "gamma_0")
    ]
    frame = pd.DataFrame(rows, columns=["kind", "name", "station", "value"])
    frame.sample(frac=1, random_state=1).sort_values("name", kind="stable").to_csv(path, index=False)
    return path


@pytest.mark.parametrize("gravity", [False, True])
def test_the_report_s_vehicle_comes_back(tmp_path, gravity):
    booster = rl.swaim_booster()
    found = rl.read_booster(written(booster, tmp_path / "own.csv"))
    ours = rl.perturbation_equations(found, gravity=gravity)
    wanted = rl.perturbation_equations(booster.recomputed(), gravity=gravity)
    assert dict(ours.coefficients) == pytest.approx(dict(wanted.coefficients), rel=1e-12)
    assert ours.gravity == pytest.approx(wanted.gravity)


def test_sums_of_the_example():
    frame = pd.read_csv(EXAMPLE, dtype={"name": str})
    mass = frame[frame.kind == "mass"]
    booster = rl.read_booster(EXAMPLE)
    centre = np.average(mass.station, weights=mass.value)
    assert pytest.approx(mass.value.sum()) == booster.M
    assert booster.l_CG == pytest.approx(centre)
    assert pytest.approx((mass.value * (mass.station - centre) ** 2).sum()) == booster.I_y
    assert booster.thrust_station == pytest.approx(340)
    first = frame[(frame.kind == "deflection") & (frame.name == "1")].set_index("station").value
    at_masses = first.reindex(mass.station).dropna()
    phi = booster.modes[0].deflection(mass.station.to_numpy(float))
    assert phi[: at_masses.size] == pytest.approx(at_masses.to_numpy())
    assert booster.modes[0].mass == pytest.approx(float(mass.value @ phi**2))
    assert [mode.omega for mode in booster.modes] == [7.0, 17.5]


def test_the_example_has_a_live_view():
    eqs = rl.perturbation_equations(rl.read_booster(EXAMPLE))
    view = explorers.rate_attitude_explorer(eqs, K_A=2.0, K_R=0.97, gyro=130)
    exact = rl.rate_attitude(eqs, K_A=2.0, K_C=10, K_R=0.97, gyro=130).poles()
    assert np.allclose(np.sort_complex(view.poles()), np.sort_complex(exact))
    assert exact.real.max() < 0


def test_any_number_of_modes(tmp_path):
    kept = [
        line for line in LINES if not line.startswith(("deflection,2", "slope,", "frequency,2", "damping,2"))
    ]
    (tmp_path / "one.csv").write_text("\n".join(kept), encoding="utf-8")
    assert rl.perturbation_equations(rl.read_booster(tmp_path / "one.csv")).states[-1] == "q1dot"


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("kind,name", "what,name", "columns in .*: got no 'kind', wanted kind, name, station, value"),
        ("flight,U,,1500", "", "flight in .*: got no U, wanted q_D, U, h, t"),
        ("flight,U,,1500", "flight,U,,fast", "value of flight U in .*: got 'fast', wanted a finite number"),
        ("flight,U,,1500", "flight,U,1500", "line .* in .*: got other cells than kind"),
        ("flight,t,,70", "flight,t,,70\nflight,Mach,,2", "flight in .*: got 'Mach'"),
        ("surface,fins", "wing,fins", "kind in .*: got 'wing', wanted one of mass, surface"),
        ("frequency,2,,17.5", "", "frequency in .*: got none of mode 2"),
        (
            "vehicle,thrust_station,,340",
            "vehicle,thrust_station,,500",
            "got station 500 ft, wanted 0 to 420 ft",
        ),
    ],
    ids=str,
)
def test_refused(tmp_path, old, new, words):
    path = tmp_path / "bad.csv"
    text = "\n".join(LINES)
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")
    with pytest.raises(ValueError, match=words):
        rl.read_booster(path)


def test_a_mass_may_lie_at_the_centre_of_gravity(tmp_path):
    text = "\n".join(line for line in LINES if not line.startswith("mass,"))
    text += "\nmass,a,100,50\nmass,b,200,70\nmass,c,300,50\n"
    (tmp_path / "even.csv").write_text(text, encoding="utf-8")
    booster = rl.read_booster(tmp_path / "even.csv")
    assert (booster.M, booster.l_CG, booster.I_y) == pytest.approx((170, 200, 1e6))
