"""A service that finds no memory ends at once and says why; any other fault of a callback ends nothing."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from rosy_sim.web.memory_shortage import EXIT_STATUS

from ..conftest import PATIENCE

SERVICE = Path(__file__).resolve().parents[2]

PROGRAM = """
import asyncio, sys
import uvloop
from rosy_sim.web.memory_shortage import MemoryShortage

async def fails(*_):
    raise eval(sys.argv[2])()

def callback():
    raise eval(sys.argv[2])()

async def main():
    if sys.argv[1] == "callback":
        asyncio.get_running_loop().call_soon(callback)
        await asyncio.sleep(0)
        await asyncio.sleep(0)
    else:
        try:
            await shortage.around(fails)({}, None, None)
        except ValueError:
            pass

shortage = MemoryShortage()
with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
    shortage.watch(runner.get_loop())
    runner.run(main())
"""


@pytest.mark.parametrize("where", ["callback", "request"])
@pytest.mark.parametrize("fault", ["MemoryError", "ValueError"])
def test_the_service_ends_with_a_sentence_when_an_allocation_fails(where: str, fault: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, where, fault],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        env={**os.environ, "PYTHONPATH": str(SERVICE), "LC_ALL": "C.UTF-8", "LANGUAGE": "en"},
        check=False,
    )
    is_shortage = fault == "MemoryError"
    assert done.returncode == (EXIT_STATUS if is_shortage else 0), done.stderr
    assert ("no memory left" in done.stderr) == is_shortage
