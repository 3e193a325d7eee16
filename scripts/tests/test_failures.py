"""Names of failed tests, from reports and outputs in the form in which the tools write them."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from testing.failures import failed_tests


def test_a_story_that_failed_and_one_that_needed_a_retry_are_named(tmp_path: Path) -> None:
    def story(title: str, status: str, *messages: str) -> dict[str, object]:
        return {"title": title, "tests": [{"status": status, "results": [{"errors": [{"message": text}]} for text in messages]}]}

    inner = {"title": "by touch", "specs": [story("drags", "unexpected", "\x1b[31mError\x1b[39m: no\n  box"), story("taps", "expected")]}
    report = tmp_path / "e2e.json"
    report.write_text(json.dumps({"suites": [{"title": "drag.spec.ts", "specs": [story("opens", "flaky", "late")], "suites": [inner]}]}))
    assert failed_tests("", report) == ["drag.spec.ts > opens: late", "drag.spec.ts > by touch > drags: Error: no box"]


def test_a_failure_of_vitest_is_named_and_so_is_a_file_that_cannot_be_loaded(tmp_path: Path) -> None:
    failed = {"fullName": "adds one", "status": "failed", "failureMessages": ["expected 2, got 3"]}
    passed = {"fullName": "adds two", "status": "passed", "failureMessages": []}
    broken = {"name": "broken.test.ts", "status": "failed", "message": "SyntaxError", "assertionResults": []}
    report = tmp_path / "editor.json"
    report.write_text(json.dumps({"testResults": [{"name": "sum.test.ts", "status": "failed", "assertionResults": [failed, passed]}, broken]}))
    assert failed_tests("", report) == ["adds one: expected 2, got 3", "broken.test.ts: SyntaxError"]


def test_pytest_names_failures_and_errors_as_this_reads_them(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text("def test_bad():\n    assert 1 == 2\n\ndef test_none(missing):\n    pass\n\ndef test_good():\n    pass\n")
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:asyncio", "test_it.py"]
    output = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False).stdout
    first, second = failed_tests(output, None)
    assert first.startswith("test_it.py::test_bad - assert 1 == 2")
    assert second.startswith("test_it.py::test_none")


def test_a_failure_of_tasty_is_named_with_its_reason() -> None:
    rows = ["Memory", "", "  holds its value:          OK (0.12s)", "", "  starts with a default:    FAIL (0.01s)", "    expected: 1", "     but got: 2"]
    rows += ["    Use -p '/starts/' to rerun this test only.", "  is read:    FAIL", "  is written:     OK"]
    assert failed_tests("\n".join(rows), None) == ["starts with a default: expected: 1 but got: 2", "is read"]


def test_of_a_long_message_the_beginning_and_the_end_are_kept() -> None:
    (line,) = failed_tests(f"FAILED test_x.py::test_y - {'word ' * 500}the end\n", None)
    assert line.startswith("test_x.py::test_y - word ")
    assert line.endswith(" word the end")
    assert len(line) < 1010


def test_the_source_below_a_message_is_left_out(tmp_path: Path) -> None:
    message = "Error: no box\nCall log:\n  - waiting for it\n\n  12 | const a = 1\n> 13 | await a\n     |       ^\n    at here.ts:13"
    report = tmp_path / "e2e.json"
    story = {"title": "drags", "tests": [{"status": "unexpected", "results": [{"errors": [{"message": message}]}]}]}
    report.write_text(json.dumps({"suites": [{"title": "drag.spec.ts", "specs": [story]}]}))
    assert failed_tests("", report) == ["drag.spec.ts > drags: Error: no box Call log: - waiting for it at here.ts:13"]


def test_why_a_process_of_the_tests_has_ended_stands_beside_the_test_it_ran(tmp_path: Path) -> None:
    (tmp_path / "test_it.py").write_text("import time\n\ndef test_hangs():\n    time.sleep(60)\n\ndef test_dies():\n    import os\n    os.abort()\n")
    limits = ["-o", "faulthandler_timeout=0.5", "-o", "faulthandler_exit_on_timeout=true"]
    command = [sys.executable, "-m", "pytest", "-q", "-rfE", "-n", "1", "-p", "no:cacheprovider", *limits, "test_it.py"]
    output = subprocess.run(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False).stdout
    lines = failed_tests(output, None)
    assert len(lines) == 2, output
    for line in lines:
        assert line.endswith("(Timeout (0:00:00.500000); Fatal Python error: Aborted)"), output
