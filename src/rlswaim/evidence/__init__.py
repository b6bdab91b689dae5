"""What the ledger sets beside each printed number: one module per report section."""

from collections.abc import Callable

from rlswaim.evidence import section_3

SECTIONS: dict[str, Callable[[], dict[str, float]]] = {"III": section_3.computed}
