"""A Kobuki that is not there, at the end of a pseudo-terminal: the emulator of the robots' suite, for asyncio."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

__all__ = ["Kobuki", "kobuki"]

EMULATOR = Path(__file__).resolve().parents[2] / "rosy-hs" / "test-robots" / "peers" / "kobuki.py"


class Kobuki:
    """What it says is kept; ``address`` is how Rosy reaches it."""

    def __init__(self, process: asyncio.subprocess.Process, device: str) -> None:
        self._process = process
        self.address = f"serial:{device}"
        self.said: list[str] = []

    def ask(self, *words: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write((" ".join(words) + "\n").encode())

    async def says(self, wanted: Callable[[str], bool]) -> str:
        """The next line that fits; waits at most a minute."""
        assert self._process.stdout is not None
        async with asyncio.timeout(60):
            while True:
                line = (await self._process.stdout.readline()).decode().strip()
                assert line or not self._process.stdout.at_eof(), self.said
                self.said.append(line)
                if wanted(line):
                    return line

    async def moves(self, speed: float) -> None:
        await self.says(lambda line: line.startswith(f"control {speed:.3f} "))

    async def marked(self) -> None:
        """From now on it counts the seconds until it stands."""
        self.ask("mark")
        await self.says(lambda line: line == "marked")

    async def stands(self) -> float:
        """Seconds from the mark to when it was told to stand, by its own clock."""
        return float((await self.says(lambda line: line.startswith("stood "))).split()[1])


@asynccontextmanager
async def kobuki(folder: Path) -> AsyncIterator[Kobuki]:
    process = await asyncio.create_subprocess_exec(
        "/usr/bin/python3",
        str(EMULATOR),
        str(folder / "kobuki"),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
    )
    assert process.stdout is not None
    try:
        device = (await process.stdout.readline()).decode().split()[1]
        yield Kobuki(process, device)
    finally:
        process.kill()
        await process.wait()
