"""Reading of test counts: every failure is seen, retries count as failures, and skipped tests are told."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from testing.counts import OTHER_VERSION, Count, Reader, by_exit, json_report, own_script, pytest_summary, tasty_summary


@pytest.mark.parametrize(
    ("reader", "output", "status", "count"),
    [
        (by_exit, "", 0, Count(1, 0)),
        (by_exit, "", 2, Count(0, 1)),
        (by_exit, "the sources follow hlint 3.3, and here it is 3.8\n", OTHER_VERSION, Count(0, 0, 1, ("the sources follow hlint 3.3, and here it is 3.8",))),
        (own_script, "x\n1864 passed, 0 failed\n", 0, Count(1864, 0)),
        (own_script, "5 passed, 1 failed, 2 skipped\n", 1, Count(5, 1, 2)),
        (own_script, "Traceback", 1, Count(0, 1)),
        (pytest_summary, "639 passed in 478.36s (0:07:58)\n", 0, Count(639, 0)),
        (pytest_summary, "1 failed, 639 passed, 3 skipped in 4.00s\n", 1, Count(639, 1, 3)),
        (pytest_summary, "2 failed, 7 passed, 1 error in 4.00s\n", 1, Count(7, 3)),
        (pytest_summary, "5 passed, 1 rerun in 4.00s\n", 0, Count(5, 1)),
        (
            pytest_summary,
            "SKIPPED [2] tests/test_a.py:9: no ROS here\n639 passed, 2 skipped, 4 deselected in 4.00s\n",
            0,
            Count(639, 0, 6, ("tests/test_a.py:9 (×2): no ROS here", "4 deselected by hand")),
        ),
        (pytest_summary, "12 passed in 4.00s\nFatal Python error", 139, Count(12, 1)),
        (pytest_summary, "ImportError while loading conftest", 4, Count(0, 1)),
        (tasty_summary, "All 172 tests passed (20.75s)\nAll 116 tests passed (1s)\n", 0, Count(288, 0)),
        (tasty_summary, "All 172 tests passed (20.75s)\n3 out of 116 tests failed (1s)\n", 1, Count(285, 3)),
        (tasty_summary, "All 172 tests passed (20.75s)\n", 1, Count(172, 1)),
        (
            tasty_summary,
            "ros\n  roscpp listens to it: OK (0.1s)\n    skipped: no rosmaster\nAll 3 tests passed (1s)\n",
            0,
            Count(2, 0, 1, ("roscpp listens to it: no rosmaster",)),
        ),
        (tasty_summary, "Build failed", 0, Count(0, 1)),
    ],
)
def test_reads_the_output(reader: Reader, output: str, status: int, count: Count) -> None:
    assert reader(output, status) == count


def test_a_story_that_passed_on_a_retry_has_failed(tmp_path: Path) -> None:
    report = tmp_path / "e2e.json"
    report.write_text(json.dumps({"stats": {"expected": 70, "unexpected": 0, "flaky": 2, "skipped": 0}}))
    assert json_report(report)("", 0) == Count(70, 2)


def test_a_skipped_story_has_its_reason(tmp_path: Path) -> None:
    skipped = {"status": "skipped", "annotations": [{"type": "skip", "description": "no Firefox here"}]}
    inner = {"specs": [{"title": "drags", "tests": [skipped]}]}
    report = tmp_path / "e2e.json"
    report.write_text(json.dumps({"stats": {"expected": 7, "unexpected": 0, "flaky": 0, "skipped": 1}, "suites": [{"suites": [inner]}]}))
    assert json_report(report)("", 0) == Count(7, 0, 1, ("drags: no Firefox here",))


def test_a_report_of_vitest_is_read(tmp_path: Path) -> None:
    report = tmp_path / "editor.json"
    left = [{"fullName": "asks GHC", "status": "pending"}, {"fullName": "adds", "status": "passed"}]
    report.write_text(
        json.dumps({"numPassedTests": 9, "numFailedTests": 1, "numPendingTests": 1, "numTodoTests": 0, "testResults": [{"assertionResults": left}]})
    )
    assert json_report(report)("", 1) == Count(9, 1, 1, ("asks GHC: what it needs is missing here",))


def test_a_missing_report_is_a_failure_even_when_the_suite_says_it_is_well(tmp_path: Path) -> None:
    assert json_report(tmp_path / "none.json")("", 0) == Count(0, 1)


def test_the_last_line_counts_everything() -> None:
    assert str(Count(2, 1)) == "2 passed, 1 failed, 0 skipped"
    assert str(Count(2, 1) + Count(1, 0, 4)) == "3 passed, 1 failed, 4 skipped"
