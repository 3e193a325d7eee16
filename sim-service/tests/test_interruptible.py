"""An interrupt ends the main thread's wait for other threads, also when the system gives the signal to one of those."""

from __future__ import annotations

import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import pytest

from rosy_sim.interruptible import results

from .conftest import PATIENCE

MAIN_THREAD_WITHOUT_SIGNALS = """
import signal, threading
from concurrent.futures import ThreadPoolExecutor
from rosy_sim.interruptible import results
with ThreadPoolExecutor(1) as pool:
    endless = threading.Event()
    waiting = pool.submit(endless.wait)
    try:
        # A shell that starts the tests in the background lets them ignore it.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        print("waits", flush=True)
        list(results([waiting]))
    except KeyboardInterrupt:
        print("interrupted", flush=True)
    endless.set()
"""


def test_a_signal_that_another_thread_takes_ends_the_wait() -> None:
    command = [sys.executable, "-c", MAIN_THREAD_WITHOUT_SIGNALS]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == "waits\n"
            process.send_signal(signal.SIGINT)
            assert process.communicate(timeout=PATIENCE)[0] == "interrupted\n"
        finally:
            process.kill()
    assert process.returncode == 0


def test_results_come_in_the_order_of_the_futures_and_errors_are_raised() -> None:
    with ThreadPoolExecutor(2) as pool:
        assert list(results([pool.submit(pow, 2, n) for n in range(5)])) == [1, 2, 4, 8, 16]
        with pytest.raises(ZeroDivisionError):
            list(results([pool.submit(divmod, 1, 0), pool.submit(divmod, 1, 1)]))
