"""Memory of a service at rest: what the kernel tells of a process, and of all below it once they compute nothing."""

from __future__ import annotations

import subprocess
import sys

import psutil

from rosy_sim.bench.resting import at_rest, share_of

ROLLUP = """55982c549000-7fffde72e000 ---p 00000000 00:00 0                          [rollup]
Rss:              409600 kB
Pss:              204800 kB
Pss_Anon:          51200 kB
Pss_File:         102400 kB
Pss_Shmem:         51200 kB
"""

BUSY_AT_FIRST = """
import subprocess, sys, time
held = bytearray(b"x" * 30 * 1024 * 1024)
while time.process_time() < 0.5: pass
child = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
print(flush=True)
input()
child.communicate(b"\\n")
"""


def test_what_no_file_backs_is_what_is_shared_too() -> None:
    share = share_of(ROLLUP, "worker")
    assert (share.proportional, share.without_file) == (200.0, 100.0)


def test_a_process_counts_with_all_below_it() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", BUSY_AT_FIRST], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as running:
        assert running.stdout is not None
        running.stdout.readline()
        shares = at_rest(psutil.Process(running.pid))
        running.communicate(b"\n")
    assert len(shares) == 2
    assert 30 <= max(share.without_file for share in shares) < 100
    assert all(0 < share.without_file <= share.proportional for share in shares)
