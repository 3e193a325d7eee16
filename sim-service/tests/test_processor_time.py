"""Processor time of a tree of processes: each counts once, whether or not its parent waited for its end."""

from __future__ import annotations

import os
import subprocess
import sys

from rosy_sim.bench.processor_time import Identity, Seen, TimeMeter, spent

TOP, CHILD, GRANDCHILD = (1, 0.0), (2, 0.0), (3, 0.0)


def tree(waited_by_top: float, waited_by_child: float) -> dict[Identity, Seen]:
    """Three generations that have computed 1, 2 and 4 s."""
    return {
        TOP: Seen(1.0, waited_by_top, None),
        CHILD: Seen(2.0, waited_by_child, TOP),
        GRANDCHILD: Seen(4.0, 0.0, CHILD),
    }


def test_all_that_are_alive_count() -> None:
    assert spent(tree(0.0, 0.0), {TOP, CHILD, GRANDCHILD}) == 7.0


def test_a_child_that_was_waited_for_counts_once() -> None:
    assert spent(tree(0.0, 4.0), {TOP, CHILD}) == 7.0
    assert spent(tree(6.0, 4.0), {TOP}) == 7.0


def test_a_child_that_nothing_waited_for_counts() -> None:
    assert spent(tree(0.0, 0.0), {TOP}) == 7.0
    assert spent(tree(0.0, 4.0), {TOP}) == 7.0


def test_what_was_too_short_to_be_seen_counts_for_the_parent_that_waited() -> None:
    assert spent(tree(0.0, 8.0), {TOP, CHILD, GRANDCHILD}) == 15.0
    # The last of its time was not seen before its end.
    assert spent(tree(0.0, 5.0), {TOP, CHILD}) == 8.0


def test_a_command_is_measured_with_all_below_it() -> None:
    # More than half a second each: the kernel counts in hundredths and leaves out what begins before the first look.
    busy = "import time\nwhile time.process_time() < 0.7: pass"
    shell = f"import subprocess, sys\nfor _ in range(2): subprocess.run([sys.executable, '-c', {busy!r}])\ninput()"
    with subprocess.Popen([sys.executable, "-c", shell], stdin=subprocess.PIPE) as running:
        with TimeMeter(lambda: [running.pid]) as meter:
            while meter.spent < 1.0:
                os.sched_yield()
        running.communicate(b"\n")
