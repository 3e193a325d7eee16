"""Limits on wrong codes: a key that guesses is limited, the others are not."""

from __future__ import annotations

from rosy_sim.attempts import Attempts, Rate
from rosy_sim.classroom.authentication import ADDRESS_ATTEMPTS, ALL_ATTEMPTS


def attempts(total: float = 1000.0) -> Attempts:
    return Attempts([Rate(0.2, 10.0), Rate(2.0, 100.0)], Rate(20.0, total), 0.0)


def wrong(limits: Attempts, keys: tuple[str, str], count: int, now: float = 0.0) -> int:
    """How many of some wrong attempts are made."""
    return sum(limits.begin(keys, now) for _ in range(count))


def test_a_page_that_guesses_is_limited_and_locks_nobody_out() -> None:
    limits = attempts()
    assert wrong(limits, ("guesser", "here"), 10_000) == 10
    assert limits.begin(("other", "here"), 0.0)
    assert not limits.begin(("guesser", "here"), 4.9)
    assert limits.begin(("guesser", "here"), 5.0)


def test_an_address_that_guesses_from_many_pages_locks_no_other_address_out() -> None:
    limits = attempts()
    assert sum(wrong(limits, (str(page), "here"), 100) for page in range(100)) == 100
    assert not limits.begin(("new", "here"), 0.0)
    assert limits.begin(("other", "there"), 0.0)


def test_all_addresses_together_are_limited() -> None:
    limits = attempts(total=50.0)
    assert sum(wrong(limits, (str(one), str(one)), 10) for one in range(100)) == 50


def test_a_right_attempt_costs_nothing() -> None:
    limits = attempts()
    for _ in range(1000):
        assert limits.begin(("page", "here"), 0.0)
        limits.succeeded(("page", "here"), 0.0)


def test_the_keys_that_are_remembered_are_limited() -> None:
    limits = attempts(total=1e9)
    for n in range(5000):
        limits.begin((str(n), str(n)), 0.0)
    assert all(len(buckets) == 1000 for _, buckets in limits._each)


def test_an_address_has_ten_wrong_codes_of_a_class_at_once_and_others_are_not_concerned() -> None:
    limits = Attempts([ADDRESS_ATTEMPTS], ALL_ATTEMPTS, 0.0)
    assert [limits.begin(["a"], 0.0) for _ in range(11)] == [True] * 10 + [False]
    assert limits.begin(["b"], 0.0)
    assert limits.begin(["a"], 6.0)
