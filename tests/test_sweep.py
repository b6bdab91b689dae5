"""Sweeps: whole, killed and resumed, on workers; and the station map that is made with them."""

import os
import signal
import subprocess
import sys
import textwrap
from functools import partial
from pathlib import Path

import distributed
import joblib
import numpy as np
import pytest
import xarray as xr

import rlswaim as rl
from rlswaim.loops.control_systems import DUAL_ACTUATION
from rlswaim.loops.station_maps import station_map
from rlswaim.loops.sweep import sweep

GAINS = {"K_A": 4.0, "K_C": 10.0, "K_R": 0.4, "kK_z": 3e4, "K_r": 10.0, "b": 3.0}
GRID = {"a": [1.0, 2.0, 3.0], "b": np.arange(5.0)}


def weigh(a, b):
    return 10 * a + b


def quiet(function, grid, **options):
    return sweep(function, grid, progress=False, **options)


def test_every_point_has_its_value_unit_and_name():
    found = quiet(weigh, GRID, chunk=4, name="weight", unit="lb", units={"a": "ft"})
    assert found.dims == ("a", "b")
    assert np.array_equal(found.sel(a=2.0).values, 20 + np.arange(5.0))
    assert (found.name, found.units, found.a.units, found.b.units) == ("weight", "lb", "ft", "1")
    assert found.attrs["rlswaim"]


@pytest.mark.parametrize("backend", ["threading", "loky"])
def test_workers_give_what_one_process_gives(backend):
    with joblib.parallel_config(backend, n_jobs=2):
        found = quiet(weigh, GRID, chunk=2)
    xr.testing.assert_identical(found, quiet(weigh, GRID, chunk=2))


@pytest.mark.parametrize("backend", ["sequential", "threading"])
def test_the_progress_bar_counts_the_points(backend, capsys):
    with joblib.parallel_config(backend, n_jobs=2):
        sweep(weigh, GRID, chunk=4)
    assert "15/15" in capsys.readouterr().err


def test_a_saved_sweep_is_read_not_computed(tmp_path):
    path = tmp_path / "saved.nc"
    first = quiet(weigh, GRID, path=path, units={"a": "ft"})
    path.touch()
    again = quiet(weigh, GRID, path=path, units={"a": "ft"})
    xr.testing.assert_identical(first, again)
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_of_another_sweep_is_refused(tmp_path):
    quiet(weigh, GRID, path=tmp_path / "saved.nc")
    with pytest.raises(ValueError, match=r"sweep: got .*saved.nc of sweep .*wanted one of"):
        quiet(weigh, {**GRID, "a": [1.0, 2.0, 4.0]}, path=tmp_path / "saved.nc")


def test_a_killed_sweep_goes_on_where_it_stopped(tmp_path):
    """A process that is killed on its way leaves whole chunks; the next run computes only the others."""
    (tmp_path / "slow.py").write_text(
        textwrap.dedent("""
        import os, signal, sys
        import numpy as np
        from rlswaim.loops.sweep import sweep

        def count(a):
            with open("calls", "a") as calls:
                calls.write("".join(f"{int(x)}\\n" for x in a))
            if a[0] >= 60 and "--die" in sys.argv:
                os.kill(os.getpid(), signal.SIGKILL)
            return a**2

        if __name__ == "__main__":
            found = sweep(count, {"a": np.arange(100.0)}, chunk=10, path="out.nc", progress=False)
            assert np.array_equal(found.values, np.arange(100.0) ** 2)
    """)
    )
    run = [sys.executable, "slow.py"]
    assert subprocess.run([*run, "--die"], cwd=tmp_path, check=False).returncode == -signal.SIGKILL
    subprocess.run(run, cwd=tmp_path, check=True)
    calls = [int(line) for line in (tmp_path / "calls").read_text().split()]
    assert sorted(set(calls)) == list(range(100))
    assert len(calls) == 110  # the chunk that was under way when the process died, and no other, ran twice


def test_bad_results_and_grids_are_refused():
    with pytest.raises(ValueError, match=r"sweep: got an array of float64 with shape \(2,\).*wanted 15 real"):
        quiet(lambda a, b: np.zeros(2), GRID)
    with pytest.raises(ValueError, match=r"sweep: got 0 points .*wanted"):
        quiet(weigh, {})
    with pytest.raises(ValueError, match=r"a\[1\] in sweep: got nan, wanted finite"):
        quiet(weigh, {"a": [1.0, np.nan], "b": [0.0]})


def abscissas_of_a_mortal(loops, mark, **at):
    """Return the abscissas at stations; the first process that gets so far dies instead, once."""
    if at["sensor"][0] > 100 and not (mark := Path(mark)).exists():
        mark.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return loops.abscissas(**GAINS, **at)


def test_dask_with_a_worker_killed_on_the_way(tmp_path):
    """Two workers on this machine, one of them killed: the map equals the serial one."""
    stations = np.arange(0.0, 421.0, 6.0)
    serial = station_map(rl.printed_equations(), stations, stations, **GAINS)
    mark, loops = tmp_path / "killed", DUAL_ACTUATION.around(rl.printed_equations())
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
        ) as cluster,
        distributed.Client(cluster),
        joblib.parallel_config("dask"),
    ):
        mortal = partial(abscissas_of_a_mortal, loops, str(mark))
        found = quiet(mortal, {"sensor": stations, "jet": stations}, chunk=100)
    assert mark.exists()
    assert np.array_equal(found.values, serial.values)


# ---- the map over sensor and jet


def test_the_map_is_the_largest_real_part():
    found = station_map(rl.printed_equations(), [39.0, 140.0], [56.0, 140.0, 395.0], **GAINS)
    for sensor in found.sensor.values:
        for jet in found.jet.values:
            poles = rl.dual_actuation(rl.printed_equations(), **GAINS, sensor=sensor, jet=jet).poles()
            assert found.sel(sensor=sensor, jet=jet).item() == pytest.approx(poles.real.max(), abs=1e-9)


def test_the_file_of_a_map_is_given_by_name(tmp_path):
    with pytest.raises(TypeError, match="positional"):
        station_map(rl.printed_equations(), [39.0], [140.0], tmp_path / "map.nc", **GAINS)


def test_the_map_refuses_stations_off_the_vehicle():
    with pytest.raises(
        ValueError, match=r"sensors\[1\] in station_map: got station 421 ft, wanted 0 to 420 ft"
    ):
        station_map(rl.printed_equations(), [0.0, 421.0], [0.0], **GAINS)


def test_without_a_bar_nothing_is_printed(tmp_path, capfd):
    """The map has no bar unless one is asked for, and a sweep that keeps its chunks tells nothing of them."""
    station_map(rl.printed_equations(), [39.0], [56.0, 140.0], **GAINS)
    quiet(weigh, GRID, chunk=4, path=tmp_path / "saved.nc")
    assert capfd.readouterr() == ("", "")
    station_map(rl.printed_equations(), [39.0], [56.0, 140.0], progress=True, **GAINS)
    assert "2/2" in capfd.readouterr().err
