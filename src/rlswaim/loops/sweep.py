"""Sweeps over a grid of parameters: in chunks, on any executor, resumed after a kill."""

import hashlib
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, as_completed
from importlib.metadata import version
from pathlib import Path

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray
from tqdm import tqdm

from rlswaim.source import checks

Function = Callable[..., NDArray]


def sweep(
    function: Function,
    grid: Mapping[str, ArrayLike],
    executor: Executor | None = None,
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
        parameter; returns m real numbers.  For another process it must be importable.
    grid : mapping of str to array_like
        The values of each parameter; all combinations are computed.
    executor : concurrent.futures.Executor, optional
        Where chunks run, for instance a process pool or Dask's ``Client.get_executor()``;
        in this process without one.
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
    """
    axes = {key: checks.frozen_array(key, np.atleast_1d(values), "sweep") for key, values in grid.items()}
    shape = tuple(axis.size for axis in axes.values())
    total = int(np.prod(shape)) if shape else 0
    if not total or chunk < 1:
        raise ValueError(f"sweep: got {total} points in chunks of {chunk}, wanted at least one point in each")
    label = f"{function.__module__}.{getattr(function, '__qualname__', type(function).__qualname__)}"
    attributes = {
        "units": unit,
        "rlswaim": version("rlswaim"),
        "function": label,
        "fingerprint": _fingerprint(axes, chunk, label + key),
    }
    store = None if path is None else _Store(Path(path), attributes["fingerprint"])
    if store and store.whole():
        return store.read(name)
    bounds = [(start, min(start + chunk, total)) for start in range(0, total, chunk)]
    values = np.empty(total)
    with tqdm(total=total, unit=" points", disable=not progress) as bar:
        for start, found in _results(function, axes, shape, bounds, executor, store):
            values[start : start + found.size] = found
            bar.update(found.size)
    coordinates = {key: (key, axis, {"units": (units or {}).get(key, "1")}) for key, axis in axes.items()}
    result = xr.DataArray(values.reshape(shape), coordinates, list(axes), name, attributes)
    if store:
        store.finish(result)
    return result


def evaluate(
    function: Function, axes: Mapping[str, NDArray], shape: tuple[int, ...], start: int, stop: int
) -> NDArray:
    """Return a function's values on points ``start`` to ``stop`` of a grid of axes; shape (stop - start,)."""
    index = np.unravel_index(np.arange(start, stop), shape)
    point = {key: axis[i] for (key, axis), i in zip(axes.items(), index, strict=True)}
    found = np.asarray(function(**point))
    if found.shape != (stop - start,) or found.dtype.kind not in "iuf":
        raise ValueError(
            f"sweep: got an array of {found.dtype} with shape {found.shape} from the function, "
            f"wanted {stop - start} real numbers"
        )
    return found.astype(float)


def _results(
    function: Function,
    axes: Mapping[str, NDArray],
    shape: tuple[int, ...],
    bounds: Sequence[tuple[int, int]],
    executor: Executor | None,
    store: "_Store | None",
) -> Iterator[tuple[int, NDArray]]:
    """Yield each chunk's start and values: stored ones first, the others as they finish."""
    waiting = []
    for start, stop in bounds:
        kept = store.load(start) if store else None
        if kept is None:
            waiting.append((start, stop))
        else:
            yield start, kept
    if executor is None:
        jobs = ((start, evaluate(function, axes, shape, start, stop)) for start, stop in waiting)
    else:
        futures = {executor.submit(evaluate, function, dict(axes), shape, *b): b[0] for b in waiting}
        jobs = ((futures[done], done.result()) for done in as_completed(futures))
    for start, found in jobs:
        if store:
            store.keep(start, found)
        yield start, found


def _fingerprint(axes: Mapping[str, NDArray], chunk: int, label: str) -> str:
    digest = hashlib.sha256(json.dumps([label, chunk, version("rlswaim"), *axes]).encode())
    for axis in axes.values():
        digest.update(axis.tobytes())
    return digest.hexdigest()[:16]


class _Store:
    """A result's NetCDF file, and the folder of finished chunks beside it."""

    def __init__(self, path: Path, fingerprint: str) -> None:
        self.path, self.fingerprint = path, fingerprint
        self.parts = path.with_name(path.name + ".parts") / fingerprint

    def whole(self) -> bool:
        """Whether the file is there; ValueError if it belongs to another sweep."""
        if not self.path.exists():
            self.parts.mkdir(parents=True, exist_ok=True)
            return False
        found = self.read("").attrs.get("fingerprint")
        if found != self.fingerprint:
            raise ValueError(
                f"sweep: got {self.path} of sweep {found}, wanted one of {self.fingerprint}; "
                "name another file or remove this one"
            )
        return True

    def read(self, name: str) -> xr.DataArray:
        with xr.open_dataarray(self.path, engine="scipy") as stored:
            return stored.load()

    def load(self, start: int) -> NDArray | None:
        part = self.parts / f"{start}.npy"
        return np.load(part) if part.exists() else None

    def keep(self, start: int, found: NDArray) -> None:
        """Write a chunk under another name first: a killed run leaves no half file."""
        half = self.parts / f"{start}.half"
        with half.open("wb") as stream:
            np.save(stream, found)
        half.replace(self.parts / f"{start}.npy")

    def finish(self, result: xr.DataArray) -> None:
        result.to_netcdf(self.path, engine="scipy")
        for part in self.parts.iterdir():
            part.unlink()
        self.parts.rmdir()
        if not any(self.parts.parent.iterdir()):
            self.parts.parent.rmdir()
