"""The causes of the ledger's disagreements: a repeated slip ends at the printed number."""

import numpy as np
import pytest

import rlswaim as rl
from rlswaim.edition import causes
from rlswaim.edition.ledger import half_unit

LEDGER = rl.ledger()
ENTRIES = {entry.id: entry for entry in LEDGER}
EQS = rl.printed_equations()
CAUSES = causes.causes()
RESULTS = causes.results()


def test_every_disagreement_has_a_cause_or_is_named_as_open():
    wanted = sorted(e.id for e in LEDGER if e.verdict not in {"agrees", "rounding"})
    assert sorted(row for cause in CAUSES for row in cause.rows) == wanted
    assert {cause.found for cause in CAUSES} == {"yes", "reading", "no"}
    for cause in CAUSES:
        open_ = any("Cause not found" in ENTRIES[row].why for row in cause.rows)
        assert not (open_ and cause.found != "no")
        assert (cause.to == "") == (cause.found == "no" or not set(cause.rows) & set(RESULTS))


@pytest.mark.parametrize("row", RESULTS)
def test_repeated_slip_ends_at_the_printed_number(row):
    (cause,) = [cause for cause in CAUSES if row in cause.rows]
    entry, result = ENTRIES[row], RESULTS[row]
    partner = row.replace("-re", "-im") if row.endswith("-re") else row.replace("-im", "-re")
    size = float(np.hypot(entry.value, ENTRIES[partner].value)) if partner != row else abs(entry.value)
    within = {
        "last digit": half_unit(entry.printed),
        "half a percent": 0.005 * abs(entry.value),
        "plot": 0.05 * size,
    }
    assert abs(result - entry.value) <= within[cause.to] * (1 + 1e-9)


def test_zeros_of_both_sensors_are_off_by_one_quadratic():
    """The printed quartics less ours: the same at both stations, in the three lowest coefficients alone."""
    found = causes.quartic_differences(EQS)
    assert np.allclose(found[0], found[1], rtol=0.02, atol=0.06)
    assert np.all(np.abs(found[:, 3:]) < 0.01)
    assert np.all(found[:, 0] > 400)
