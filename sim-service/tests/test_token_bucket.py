"""Allowances: what may be asked for at once and for long."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rosy_sim.token_bucket import Share, TokenBucket


@given(st.lists(st.tuples(st.floats(0, 1), st.floats(0.1, 5)), max_size=50))
def test_no_more_is_spent_than_has_grown(plan: list[tuple[float, float]]) -> None:
    budget, now, spent = TokenBucket(10.0, 20.0, 0.0), 0.0, 0.0
    for pause, cost in plan:
        now += pause
        spent += cost if budget.spend(cost, now) else 0.0
        assert spent <= 20.0 + 10.0 * now + 1e-6


def test_an_overdraft_tells_how_long_to_wait() -> None:
    budget = TokenBucket(10.0, 20.0, 0.0)
    assert budget.overdraw(20.0, 0.0) == 0.0
    assert budget.overdraw(5.0, 0.0) == 0.5
    assert budget.overdraw(0.0, 0.5) == 0.0


def test_clients_that_overdraw_have_one_share_together_and_another_has_its_own() -> None:
    together = TokenBucket(1.0, 1.0, 0.0)
    greedy, modest = (Share(TokenBucket(10.0, 10.0, 0.0), together) for _ in range(2))
    assert greedy.overdraw(21.0, 0.0) == 20.0
    # Its own debt is paid after 1.1 s.
    assert greedy.overdraw(0.0, 2.0) == 18.0
    assert modest.overdraw(9.0, 2.0) == 0.0
    # When both are full again it is a client like another.
    assert greedy.overdraw(9.0, 30.0) == 0.0
    assert greedy.overdraw(1.0, 30.0) == 0.0
