"""Tables 1 to 3 in the report's own layout: each cell a printed number's id, or a text."""

from collections.abc import Callable
from dataclasses import dataclass

from rlswaim.edition.equations_as_printed import rows
from rlswaim.source import checks
from rlswaim.source.tables import Row, column, read_table

NOT_USED = "not used"


@dataclass(frozen=True)
class PrintedTable:
    """A table of the report: caption, heads (TeX between dollars), and lines of cells."""

    caption: str
    heads: tuple[str, ...]
    lines: tuple[tuple[str, ...], ...]

    @property
    def entries(self) -> tuple[str, ...]:
        """Ids of the printed numbers in it, line by line."""
        return tuple(cell for line in self.lines for cell in line if cell in rows())


def _stations() -> list[str]:
    return [f"{x:g}" for x in column("masses", "station_ft")]


def _masses() -> PrintedTable:
    lines = [(x, f"tab1-m-{x}", f"tab1-arm-{x}", f"tab1-I_y-{x}") for x in _stations()]
    lines.append(("total", "tab1-M", "", "tab1-I_y"))
    heads = ("station (ft)", "$m$ (slugs)", r"$\ell_{CG}-\ell$ (ft)", "$I_y$ (slugs-ft²)")
    return PrintedTable("Mass data", heads, tuple(lines))


def _modes() -> PrintedTable:
    """Table 2: a slope stands where a force acts; the machine reading has lost those of station 407."""
    shown = {name: (name if name in rows() else "") for x in _stations() for name in _slopes(x)}
    shown |= dict.fromkeys(_slopes("65"), NOT_USED)
    cells = ("tab2-phi_1", "tab2-phi_2", "tab2-mass_1", "tab2-mass_2")
    lines = [
        (x, *(f"{cell}-{x}" for cell in cells), *(shown[name] for name in _slopes(x))) for x in _stations()
    ]
    lines.append(("total", "", "", "tab2-mass_1", "tab2-mass_2", "", ""))
    heads = ("station (ft)", r"$\phi_1$", r"$\phi_2$", r"$m\phi_1^2$ (slugs)", r"$m\phi_2^2$ (slugs)")
    return PrintedTable("Mode shape data", (*heads, r"$\sigma_1$ (1/ft)", r"$\sigma_2$ (1/ft)"), tuple(lines))


def _slopes(station: str) -> tuple[str, str]:
    return f"tab2-sigma_1-{station}", f"tab2-sigma_2-{station}"


def _pairs() -> PrintedTable:
    """Table 3: two cases a line, as the report sets them."""
    cases = [row["case"] for row in read_table("table3")]
    half = len(cases) // 2
    cells = {case: (case, f"tab3-sensor-{case}", f"tab3-jet-{case}") for case in cases}
    lines = (cells[a] + cells[b] for a, b in zip(cases[:half], cases[half:], strict=True))
    return PrintedTable(
        "Sensor-actuator combinations", ("case", "sensor station", "actuator station") * 2, tuple(lines)
    )


TABLES: dict[str, Callable[[], PrintedTable]] = {"1": _masses, "2": _modes, "3": _pairs}


def printed_table(number: str | int) -> PrintedTable:
    """Return the table of the report with this ``number``: 1, 2 or 3.

    Raises
    ------
    ValueError
        If the report has no such table.
    """
    return TABLES[checks.one_of("table", str(number), tuple(TABLES))]()


def row_of(cell: str) -> Row | None:
    """Return the ledger's row of a ``cell``, or None if it is a text."""
    return rows().get(cell)
