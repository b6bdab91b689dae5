"""Bad numbers and bad stations, and the check that a call refuses them with what, where, got and wanted."""

import numpy as np
import pytest

NOT_NUMBERS = {
    "text": "1.0",
    "complex": 1 + 0j,
    "None": None,
    "bool": True,
    "list": [1.0],
    "array": np.array([1.0, 2.0]),
    "numpy bool": np.bool_(False),
}
NOT_FINITE = {"nan": np.nan, "inf": np.inf, "-inf": -np.inf, "numpy nan": np.float64("nan")}
OFF_THE_VEHICLE = {"ahead of the nose": -1, "behind the thrust point": 421, "just outside": 420.0001}


def refused(error, call, *words):
    """Check that a call is refused, and that the message has each word, what was got and what was wanted."""
    with pytest.raises(error) as caught:
        call()
    message = str(caught.value)
    for word in (*words, "got", "wanted"):
        assert word in message, f"{word!r} is missing in: {message}"


def cases(*tables):
    """Return the rows of the tables as pytest parameters with readable ids."""
    return [pytest.param(value, id=name) for table in tables for name, value in table.items()]
