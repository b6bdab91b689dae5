"""The stored gains and draws come out again."""

import pytest

from rlswaim.practice import designs, monte_carlo, synthesis
from rlswaim.practice.criteria import wanted


def test_stored_gains_cost_what_the_table_says():
    found, cases = designs.synthesized(), synthesis.worst_cases()
    assert set(found) <= set(synthesis.STRUCTURES)
    costs = []
    for structure, row in found.items():
        cost = synthesis.weighed([synthesis.ratios(eqs, row, wanted()) for eqs in cases])
        assert cost == pytest.approx(row["cost"], rel=1e-3)
        assert cost == pytest.approx(min(v for name, v in row.items() if name.startswith("start")), rel=1e-3)
        assert synthesis.place_of(structure, row).min() >= 0
        costs.append(cost)
    assert costs == sorted(costs, reverse=True)  # the richer structure is no worse


def test_stored_draws_come_out_again():
    rows = [monte_carlo.one_draw(index) for index in range(monte_carlo.FIRST)]
    stored = monte_carlo.spreads()
    assert set(stored) == set(designs.designs())
    for name, table in stored.items():
        again = monte_carlo.spread([row[name] for row in rows])
        assert again.first == pytest.approx(table.first, rel=2e-3, abs=1e-6)
        assert table.draws >= 2000
        low, high = table.share()
        assert low <= table.stable / table.draws <= high
