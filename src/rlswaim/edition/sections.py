"""What the ledger sets beside each printed number: one module per report section."""

from collections.abc import Callable

from rlswaim.edition import section_2, section_3, section_4, section_5, section_6, section_7

SECTIONS: dict[str, Callable[[], dict[str, float]]] = {
    "II": section_2.computed,
    "III": section_3.computed,
    "IV": section_4.computed,
    "V": section_5.computed,
    "VI": section_6.computed,
    "VII": section_7.computed,
}
