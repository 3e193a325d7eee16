"""A service with one robot in a process of its own, so that it can be killed: ``robot_service ADDRESS FOLDER``."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

from rosy_sim.config import Config, Limits, discover

from ..conftest import FAKE_WORKER, PATIENCE
from ..web.page_client import serving


async def main(robot: str, folder: Path) -> None:
    config = Config(
        root=folder,
        page=folder / "page",
        examples=folder / "examples",
        worker=(sys.executable, str(FAKE_WORKER)),
        sandbox=False,
        robot_executable=discover().robot_executable,
        robots={"Kitchen": robot},
        recordings=folder / "recordings",
        # A page that gets no processor for a while is still there.
        limits=Limits(settle=60.0, ready=60.0, unattended=PATIENCE),
    )
    async with serving(config) as (address, service):
        print(address, service.robots.code, flush=True)
        await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], Path(sys.argv[2])))
