"""Stations of sensors and jets: Table 3's pairs and their readings, zeros and poles over the stations."""

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import CenteredNorm
from numpy.typing import ArrayLike, NDArray

from rlswaim.edition.table_3 import Trial
from rlswaim.edition.table_3_readings import Readings
from rlswaim.figures.style import COLORS
from rlswaim.loops.closures import direct_response
from rlswaim.rootlocus.locus import RootLocus
from rlswaim.vehicle.equations import PerturbationEquations

LOOKS = {
    "no": ("o", COLORS["neutral"]),
    "higher at the end": ("s", COLORS["rigid"]),
    "rises throughout": ("^", COLORS["mode 2"]),
}


def draw_table_3(ax: Axes, pairs: Sequence[Trial], eqs: PerturbationEquations) -> Axes:
    """Draw Table 3: a marker for each pair of stations, and where the jet has no direct effect at the sensor.

    Parameters
    ----------
    ax : Axes
    pairs : sequence of Trial
        From `rlswaim.edition.table_3.trials`; a ring marks pairs that leave no root right of the axis
        at some gain.
    eqs : PerturbationEquations

    Returns
    -------
    Axes
    """
    x = np.arange(0.0, 421.0, 2.0)
    ax.contour(
        x,
        x,
        direct_response(eqs, x[None, :], x[:, None]),
        levels=[0.0],
        colors=COLORS["jet"],
        linestyles="--",
    )
    ax.plot([], [], "--", color=COLORS["jet"], label="no direct effect: Σ φ(z) φ(r)/m = 0")
    for outcome, (marker, color) in LOOKS.items():
        chosen = [p for p in pairs if p.outcome == outcome]
        ax.plot([p.sensor for p in chosen], [p.jet for p in chosen], marker, ms=7, color=color, label=outcome)
    steady = [p for p in pairs if p.steadies]
    ax.plot(
        [p.sensor for p in steady],
        [p.jet for p in steady],
        "o",
        ms=14,
        mfc="none",
        mec=COLORS["mode 1"],
        label="no root right of the axis",
    )
    for p in pairs:
        beside = any(abs(p.sensor - q.sensor) < 8 and p.jet == q.jet and q.case < p.case for q in pairs)
        ax.annotate(
            str(p.case),
            (p.sensor, p.jet),
            (-14, -12) if beside else (6, 6),
            textcoords="offset points",
            fontsize=8,
        )
    ax.set(
        xlabel="station of the sensor (ft)", ylabel="station of the jet (ft)", xlim=(0, 420), ylim=(0, 420)
    )
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    return ax


def draw_readings(ax: Axes, groups: Sequence[Sequence[Readings]], labels: Sequence[str]) -> Axes:
    """Draw which share of the readings stiffens both modes throughout, for each pair of Table 3.

    Parameters
    ----------
    ax : Axes
    groups : sequence of sequence of Readings
        One for each box of readings, all with the same pairs.
    labels : sequence of str
        What the boxes are.

    Returns
    -------
    Axes
    """
    width = 0.8 / len(groups)
    looks = (("mode 2", None), ("rigid", "//"), ("mode 1", ".."))
    for i, (group, label, (color, hatch)) in enumerate(zip(groups, labels, looks, strict=False)):
        x = np.array([r.nominal.case for r in group]) + (i - (len(groups) - 1) / 2) * width
        shares = [100 * r.rises / r.total for r in group]
        ax.bar(x, shares, width, color=COLORS[color], hatch=hatch, edgecolor="white", label=label)
        barred = [at for at, r in zip(x, group, strict=True) if r.barred]
        text = "none, exactly" if not i else None
        ax.plot(barred, np.zeros(len(barred)), "x", color=COLORS["printed"], ms=4, label=text, clip_on=False)
    ax.set(xlabel="case of Table 3", ylabel="readings that stiffen both modes (%)", ylim=(0, 100))
    ax.set_xticks([r.nominal.case for r in groups[0]])
    ax.grid(False, axis="x")
    ax.legend(ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1.0), fontsize=8)
    return ax


def draw_sensor_zeros(
    ax: Axes, stations: NDArray, zeros: NDArray, printed: Mapping[float, ArrayLike]
) -> Axes:
    """Draw the zeros of Eq. 119 as size |s| over the sensor station, real and complex ones apart.

    Parameters
    ----------
    ax : Axes
    stations : ndarray, shape (K,)
        Sensor stations (ft).
    zeros : ndarray of complex, shape (K, n)
    printed : mapping of station to zeros
        Complex zeros that the report prints (1/s).

    Returns
    -------
    Axes
    """
    at = np.broadcast_to(stations[:, None], zeros.shape)
    for what, chosen, style in (
        ("real, right half plane", (zeros.imag == 0) & (zeros.real > 0), ("^", "mode 2")),
        ("real, left half plane", (zeros.imag == 0) & (zeros.real < 0), ("v", "rigid")),
        ("complex pair", zeros.imag > 0, ("o", "mode 1")),
    ):
        ax.plot(
            at[chosen], np.abs(zeros[chosen]), style[0], ms=3.5, mfc="none", mec=COLORS[style[1]], label=what
        )
    for i, (station, pairs) in enumerate(printed.items()):
        size = np.abs(np.asarray(pairs))
        label = None if i else "printed pairs"
        ax.plot(np.full(size.shape, station), size, "D", ms=8, mfc="none", mec=COLORS["printed"], label=label)
    ax.set(xlabel="sensor station (ft)", ylabel="|zero| (1/s)")
    return ax


def draw_pole_map(ax: Axes, locus: RootLocus, label: str = "station (ft)") -> Axes:
    """Draw the closed-loop poles of a `parameter_locus` over stations, the station as color.

    Parameters
    ----------
    ax : Axes
    locus : RootLocus
        Its ``gains`` are the stations (ft).
    label : str
        Of the color scale.

    Returns
    -------
    Axes
    """
    points = np.column_stack([locus.roots.real.ravel(), locus.roots.imag.ravel()])
    stations = np.repeat(locus.gains, locus.roots.shape[1])
    upper = points[:, 1] >= 0
    shown = ax.scatter(points[upper, 0], points[upper, 1], c=stations[upper], s=8, cmap="viridis", zorder=3)
    ax.axvline(0.0, color=COLORS["neutral"], lw=0.8)
    ax.set(xlabel="Re s (1/s)", ylabel="Im s (rad/s)")
    ax.figure.colorbar(shown, ax=ax, label=label)
    return ax


def draw_station_map(ax: Axes, abscissa: xr.DataArray) -> Axes:
    """Draw the largest real part of the closed loop's poles over sensor and jet stations, 0 as a line.

    Parameters
    ----------
    ax : Axes
    abscissa : DataArray
        From `station_map`: dimensions sensor and jet (ft), values in 1/s.

    Returns
    -------
    Axes
    """
    at = abscissa.sensor.values, abscissa.jet.values, abscissa.values.T
    levels = np.array([-0.2, 0.0, 0.4, 0.8, 1.2, 1.6, 2.0])
    shown = ax.contourf(*at, levels=levels, cmap="PuOr_r", norm=CenteredNorm(0.0, 2.0), extend="both")
    ax.contour(*at, levels=[0.0], colors="k", linewidths=1.2)
    ax.figure.colorbar(shown, ax=ax, label="largest real part (1/s)")
    ax.set(xlabel="station of the sensor (ft)", ylabel="station of the jet (ft)")
    return ax
