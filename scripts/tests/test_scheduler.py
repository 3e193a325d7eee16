"""Scheduling of suites: cores are shared, order is kept, and nothing is left running."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from testing.counts import by_exit
from testing.scheduler import BACKGROUND_NICE, Result, Suite, run_all


class Watch:
    """Records which suites ran at the same time, and the order in which they ended."""

    def __init__(self) -> None:
        self.together: list[frozenset[str]] = []
        self.results: list[Result] = []

    def changed(self, names: Sequence[str]) -> None:
        self.together.append(frozenset(names))

    def run(self, suites: Sequence[Suite], cores: float, folder: Path) -> None:
        run_all(suites, cores, folder, folder, dict(os.environ), self.changed, self.results.append)


def python(name: str, program: str, cores: float = 1, after: Sequence[str] = ()) -> Suite:
    return Suite(name, [sys.executable, "-c", program], by_exit, cores=cores, after=frozenset(after))


def in_background(name: str, program: str) -> Suite:
    return replace(python(name, program), background=True)


def test_two_suites_run_at_once_on_two_cores(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo")
    watch = Watch()
    # Opening a named pipe waits for the other end.
    watch.run([python("writer", "open('fifo', 'w').write('hello')"), python("reader", "assert open('fifo').read() == 'hello'")], 2, tmp_path)
    assert {r.suite.name: r.count.passed for r in watch.results} == {"writer": 1, "reader": 1}


def test_half_a_core_lets_a_suite_run_beside_others(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "first")
    os.mkfifo(tmp_path / "second")
    watch = Watch()
    # Each of the three waits for the one before it.
    chain = [
        python("a", "open('first', 'w').write('hello')"),
        python("b", "assert open('first').read() == 'hello'; open('second', 'w').write('hello')", cores=0.5),
        python("c", "assert open('second').read() == 'hello'"),
    ]
    watch.run(chain, 2.5, tmp_path)
    assert sum(result.count.passed for result in watch.results) == 3
    assert frozenset("abc") in watch.together


def test_no_more_cores_are_used_than_there_are(tmp_path: Path) -> None:
    watch = Watch()
    watch.run([python("large", "", cores=2), python("a", ""), python("b", ""), python("c", "")], 2, tmp_path)
    assert len(watch.results) == 4
    assert all(names <= {"a", "b", "c"} or names == {"large"} for names in watch.together)
    assert max(len(names) for names in watch.together) <= 2


def test_a_suite_that_wants_more_cores_than_there_are_runs_alone(tmp_path: Path) -> None:
    watch = Watch()
    watch.run([python("a", ""), python("large", "", cores=8)], 1, tmp_path)
    assert max(len(names) for names in watch.together) == 1
    assert len(watch.results) == 2


def test_one_suite_at_a_time_runs_in_the_background_of_busy_cores(tmp_path: Path) -> None:
    for fifo in ("a", "go"):
        os.mkfifo(tmp_path / fifo)
    watch = Watch()
    # The one that needs all cores ends once the one in the background has answered.
    suites = [
        python("busy", "assert open('a').read() == 'hello'; open('go', 'w').write('hello')", cores=2),
        in_background("a", "open('a', 'w').write('hello'); assert open('go').read() == 'hello'"),
        in_background("b", ""),
        in_background("c", ""),
    ]
    watch.run(suites, 2, tmp_path)
    assert sum(result.count.passed for result in watch.results) == 4
    assert all(len(names - {"busy"}) <= 1 for names in watch.together)


def test_a_suite_in_the_background_has_a_low_priority(tmp_path: Path) -> None:
    watch = Watch()
    watch.run([in_background("patient", "import os; print(os.nice(0))"), python("prompt", "import os; print(os.nice(0))")], 1, tmp_path)
    patient, prompt = (next(int(r.output) for r in watch.results if r.suite.name == name) for name in ("patient", "prompt"))
    # This process may itself be in the background.
    assert prompt == os.nice(0)
    assert patient == min(os.nice(0) + BACKGROUND_NICE, 19)


def test_a_suite_waits_for_those_it_comes_after(tmp_path: Path) -> None:
    watch = Watch()
    watch.run([python("second", "", after=["first"]), python("first", "")], 2, tmp_path)
    assert [r.suite.name for r in watch.results] == ["first", "second"]


def test_output_and_status_reach_the_result(tmp_path: Path) -> None:
    watch = Watch()
    watch.run([python("bad", "import sys; print('what is wrong'); sys.exit(3)")], 1, tmp_path)
    (result,) = watch.results
    assert (result.count.failed, result.output) == (1, "what is wrong\n")
    assert (tmp_path / "test-bad.log").read_text() == "what is wrong\n"


def test_a_suite_that_takes_too_long_is_ended_and_its_output_is_kept(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "never")
    watch = Watch()
    endless = python("endless", "print('the last words', flush=True); open('never')")
    watch.run([replace(endless, limit=0.1), python("next", "")], 1, tmp_path)
    assert {r.suite.name: (r.count.passed, r.count.failed) for r in watch.results} == {"endless": (0, 1), "next": (1, 0)}
    (ended,) = (r for r in watch.results if r.suite.name == "endless")
    assert "took longer than" in ended.output


def test_processor_time_counts_what_a_suite_starts(tmp_path: Path) -> None:
    watch = Watch()
    # Computes for 50 ms of processor time in a process of its own, however long that takes.
    busy = "import time; end = time.process_time() + 0.05\nwhile time.process_time() < end: pass"
    watch.run([python("busy", f"import subprocess, sys; subprocess.run([sys.executable, '-c', {busy!r}])")], 1, tmp_path)
    (result,) = watch.results
    assert result.computing >= 0.05


@pytest.fixture
def interruptible() -> Iterator[None]:
    """A shell that starts the tests in the background has SIGINT ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interruptible")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_what_was_started(tmp_path: Path, number: signal.Signals) -> None:
    os.mkfifo(tmp_path / "alive")
    # Holds the pipe open until it ends, and so do its children.
    suite = python("endless", "import subprocess, sys; f = open('alive', 'w'); subprocess.run(['sleep', '1000'], pass_fds=[f.fileno()])")
    reader = os.open(tmp_path / "alive", os.O_RDONLY | os.O_NONBLOCK)

    def interrupt(_names: Sequence[str]) -> None:
        signal.raise_signal(number)

    with pytest.raises(KeyboardInterrupt):
        run_all([suite], 1, tmp_path, tmp_path, dict(os.environ), interrupt, lambda _result: None)
    os.set_blocking(reader, True)
    # The end of the file comes once every writer is gone.
    assert os.read(reader, 1) == b""
    os.close(reader)
