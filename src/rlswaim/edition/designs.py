"""The report's designs: gains and stations of its control systems, figure by figure."""

from rlswaim.source import checks
from rlswaim.source.tables import number, read_table


def value(cell: str) -> float | str:
    """Return what a ``cell`` of a table of gains stands for: a number, or else its words."""
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
