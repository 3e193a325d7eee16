"""Tests that take turns: each is run once in thirteen days, nightly, and while its file or package has changed."""

from __future__ import annotations

import pytest

from .extent import DAYS, Day

TESTS = [(f"a.py::test_{n}", "a.py") for n in range(10)] + [(f"b.py::test_{n}", "b.py") for n in range(6)]
NAMES = sorted(name for name, _ in TESTS)


@pytest.mark.parametrize("first", [0, 20783, 20784, 20785])
def test_thirteen_days_run_each_test_once(first: int) -> None:
    shares = [Day(first + day, whole=False).share(TESTS) for day in range(DAYS)]
    assert sorted(name for share in shares for name in share) == NAMES
    assert all(abs(len(share) - len(TESTS) / DAYS) < 1 for share in shares)


def test_the_order_in_which_tests_are_found_changes_nothing() -> None:
    assert Day(1, whole=False).share(TESTS) == Day(1, whole=False).share(reversed(TESTS))


def test_nightly_runs_all_and_a_changed_file_runs_all_of_its_own() -> None:
    assert sorted(Day(0, whole=True).share(TESTS)) == NAMES
    today = Day(0, whole=False).share(TESTS)
    changed = Day(0, whole=False, changed=frozenset({"b.py"})).share(TESTS)
    assert changed == today | {name for name, file in TESTS if file == "b.py"}


def test_a_changed_package_runs_all_of_its_own() -> None:
    tests = [
        (f"sim-service/tests/{folder}/test_a.py::test_{n}", f"sim-service/tests/{folder}/test_a.py")
        for folder in ("run", "web")
        for n in range(9)
    ]
    today = Day(0, whole=False).share(tests)
    changed = Day(0, whole=False, changed=frozenset({"sim-service/rosy_sim/run/steps/lockstep.py"})).share(tests)
    assert changed == today | {name for name, file in tests if "/run/" in file}


@pytest.mark.parametrize("source", ["cli/parser.py", "cli.py"])
def test_a_changed_module_runs_the_file_that_is_named_like_it(source: str) -> None:
    tests = [(f"sim-service/tests/test_cli.py::test_{n}", "sim-service/tests/test_cli.py") for n in range(20)]
    assert len(Day(0, whole=False, changed=frozenset({f"sim-service/rosy_sim/{source}"})).share(tests)) == 20


def test_a_changed_program_of_the_guide_runs_those_of_the_language() -> None:
    tests = [
        (f"sim-service/tests/system/test_guide.py::test_{n}", "sim-service/tests/system/test_guide.py")
        for n in range(20)
    ]
    assert len(Day(0, whole=False, changed=frozenset({"docs/class.md"})).share(tests)) == 20
    assert len(Day(0, whole=False, changed=frozenset({"README.md"})).share(tests)) < 3


def test_a_changed_robot_process_runs_those_of_the_robots() -> None:
    tests = [
        (f"sim-service/tests/ownership/test_deaths.py::test_{n}", "sim-service/tests/ownership/test_deaths.py")
        for n in range(20)
    ]
    assert len(Day(0, whole=False, changed=frozenset({"rosy-hs/robots/Rosy/Robots/Guard.hs"})).share(tests)) == 20
