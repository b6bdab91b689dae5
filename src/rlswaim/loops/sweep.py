"""Sweeps over a grid of parameters: in chunks, wherever joblib runs them, and resumed after a kill."""

import os
import shutil
from collections.abc import Callable, Mapping
from importlib.metadata import version
from pathlib import Path

import joblib
import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray
from tqdm import tqdm

from rlswaim.source import checks

Function = Callable[..., NDArray]


def sweep(
    function: Function,
    grid: Mapping[str, ArrayLike],
    *,
    chunk: int = 10_000,
    name: str = "value",
    unit: str = "1",
    units: Mapping[str, str] | None = None,
    path: str | os.PathLike[str] | None = None,
    key: str = "",
    progress: bool = True,
) -> xr.DataArray:
    """Return a function's values on every point of a grid.

    Parameters
    ----------
    function : callable
        Called as ``function(a=..., b=...)`` with one array of shape (m,) for each
        parameter; returns m real numbers.
    grid : mapping of str to array_like
        The values of each parameter; all combinations are computed.
    chunk : int
        Points a chunk.
    name, unit : str
        Of the result.
    units : mapping of str to str, optional
        Of the parameters.
    path : path-like, optional
        NetCDF file for the result.  Finished chunks are kept beside it until it is
        whole, so that the same call goes on where a killed one stopped; a whole file is read, not computed.
    key : str
        What else tells this sweep from others, for instance the gains that stay fixed.
    progress : bool
        Whether a progress bar is shown.

    Returns
    -------
    xarray.DataArray
        One dimension for each parameter, with units, names and the version of rlswaim as attributes.

    Raises
    ------
    ValueError
        If the grid is empty or not finite, a chunk's result has another shape or is no number,
        or the file belongs to another sweep.

    Notes
    -----
    Chunks run in this process, or within ``with joblib.parallel_config(...)`` where that says: in
    threads, in processes, or on the workers of a Dask cluster.
    """
    axes = {key: checks.frozen_array(key, np.atleast_1d(values), "sweep") for key, values in grid.items()}
    total = int(np.prod([axis.size for axis in axes.values()])) if axes else 0
    if not total or chunk < 1:
        raise ValueError(f"sweep: got {total} points in chunks of {chunk}, wanted at least one point in each")
    named = getattr(function, "func", function)  # what a functools.partial calls
    label = f"{named.__module__}.{getattr(named, '__qualname__', type(named).__qualname__)}"
    attributes = {"units": unit, "rlswaim": version("rlswaim"), "function": label}
    attributes["fingerprint"] = joblib.hash([label, key, version("rlswaim"), list(axes), list(axes.values())])
    if path is None:
        values = _values(evaluate, function, axes, total, chunk, progress)
    elif Path(path).exists():
        return _read(Path(path), attributes["fingerprint"])
    else:
        parts = Path(f"{path}.{attributes['fingerprint']}.parts").absolute()
        kept = joblib.Memory(parts, verbose=0).cache(evaluate, ignore=["function", "axes"])
        values = _values(kept, function, axes, total, chunk, progress)
    coordinates = {key: (key, axis, {"units": (units or {}).get(key, "1")}) for key, axis in axes.items()}
    shape = [axis.size for axis in axes.values()]
    result = xr.DataArray(values.reshape(shape), coordinates, list(axes), name, attributes)
    if path is not None:
        result.to_netcdf(parts / "whole.nc", engine="scipy")
        (parts / "whole.nc").replace(path)
        shutil.rmtree(parts)
    return result


def evaluate(function: Function, axes: Mapping[str, NDArray], start: int, stop: int) -> NDArray:
    """Return a function's values on some points of a grid.

    Parameters
    ----------
    function : callable
        As in `sweep`.
    axes : mapping of str to ndarray
        The values of each parameter.
    start, stop : int
        The first of the points, and the one after the last, the last parameter running fastest.

    Returns
    -------
    ndarray, shape (stop - start,)

    Raises
    ------
    ValueError
        If the function returns something else than so many real numbers.
    """
    index = np.unravel_index(np.arange(start, stop), tuple(axis.size for axis in axes.values()))
    point = {key: axis[i] for (key, axis), i in zip(axes.items(), index, strict=True)}
    found = np.asarray(function(**point))
    if found.shape != (stop - start,) or found.dtype.kind not in "iuf":
        raise ValueError(
            f"sweep: got an array of {found.dtype} with shape {found.shape} from the function, "
            f"wanted {stop - start} real numbers"
        )
    return found.astype(float)


class _Parallel(joblib.Parallel):
    """Runs chunks where joblib's context says, and moves a progress bar on after each."""

    def __init__(self, bar: tqdm, chunk: int) -> None:
        super().__init__()
        self.bar, self.chunk = bar, chunk

    def print_progress(self) -> None:
        self.bar.update(min(self.n_completed_tasks * self.chunk, self.bar.total) - self.bar.n)


def _values(
    run: Function, function: Function, axes: Mapping[str, NDArray], total: int, chunk: int, progress: bool
) -> NDArray:
    """Return the values on all points by ``run``, which is `evaluate` with or without a memory."""
    with tqdm(total=total, unit=" points", disable=not progress) as bar:
        jobs = (
            joblib.delayed(run)(function, dict(axes), start, min(start + chunk, total))
            for start in range(0, total, chunk)
        )
        return np.concatenate(_Parallel(bar, chunk)(jobs))


def _read(path: Path, fingerprint: str) -> xr.DataArray:
    """Return a stored result; ValueError if it belongs to another sweep."""
    with xr.open_dataarray(path, engine="scipy") as stored:
        result = stored.load()
    if (found := result.attrs.get("fingerprint")) != fingerprint:
        raise ValueError(
            f"sweep: got {path} of sweep {found}, wanted one of {fingerprint}; "
            "name another file or remove this one"
        )
    return result
