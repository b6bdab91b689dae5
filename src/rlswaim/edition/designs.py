"""The report's designs: gains and stations of its control systems, figure by figure."""

import re

from rlswaim.source import checks
from rlswaim.source.tables import number, read_table


def value(cell: str) -> float | str:
    """Return the number in a ``cell`` of a table of gains, or its text if it holds no number."""
    try:
        return number(cell)
    except ValueError:
        return cell


def designs(section: str) -> dict[str, dict[str, float | str]]:
    """Return the report's designs of one ``section``: parameters by name of the design."""
    found: dict[str, dict[str, float | str]] = {}
    for row in read_table("designs"):
        if row["section"] == section:
            found.setdefault(row["name"], {})[row["parameter"]] = value(row["value"])
    return found


def found_gains(system: str) -> dict[str, float]:
    """Return the gains and stations of a ``system`` (``dual_actuation``) that were found by hand."""
    rows = [row for row in read_table("gains_found") if row["system"] == system]
    checks.one_of("system", system, {row["system"] for row in read_table("gains_found")}, "found_gains")
    return {row["parameter"]: float(value(row["value"])) for row in rows}


def instrument_stations() -> dict[str, tuple[float, ...]]:
    """Return the stations (ft) at which the report's text and figures place gyros, sensors and jet.

    Returns
    -------
    dict of str to tuple of float
        By ``"gyros"`` [Section IV], ``"linear sensors"`` [Sections V to VII] and ``"jet"`` [Section VII],
        from the nose aft.
    """
    patterns = {
        "gyros": r"sigma-(?P<station>\d+)-mode1",
        "linear sensors": r"(?:sec5-sensor-\d+|fig\d+-sensor(?:_[ab])?)",
        "jet": r"fig\d+-jet",
    }
    found: dict[str, set[float]] = {name: set() for name in patterns}
    for row in read_table("printed"):
        for name, pattern in patterns.items():
            if match := re.fullmatch(pattern, row["id"]):
                found[name].add(number(match.groupdict().get("station", row["printed"])))
    return {name: tuple(sorted(stations)) for name, stations in found.items()}
