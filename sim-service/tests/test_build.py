"""./rosy build: native files that drive a robot behind a rosbridge server, here ours."""

from __future__ import annotations

import asyncio
import subprocess
from pathlib import Path

import pytest

from rosy_sim.build import _newest
from rosy_sim.cli import main
from rosy_sim.config import Config, discover

from .test_app import opened, serving

ROOT = discover().root

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(
        _newest(ROOT, "dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-build/**/rosy-build") is None,
        reason="rosy-build is not built",
    ),
]


def built(name: str, folder: Path) -> Path:
    binary = folder / name
    assert main(["build", str(ROOT / "examples" / name / "Main.hs"), "-o", str(binary)]) == 0
    return binary


@pytest.mark.parametrize("name", ["accelerateAndPlay", "randomWalk"])
def test_a_built_program_drives_a_robot(name: str, tmp_path: Path, config: Config) -> None:
    binary = built(name, tmp_path)

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            robot = f"ws://{address}/rosbridge/{hello['session']}"
            program = await asyncio.create_subprocess_exec(binary, "--robot", robot)
            try:
                await page.until(lambda m: m["op"] == "frame" and m["v"] > 0.1)
                await page.until(lambda m: m["op"] == "frame" and m["bumpers"] != 0)
            finally:
                program.terminate()
                await program.wait()
            await page.until(lambda m: m["op"] == "frame" and m["v"] == 0)

    asyncio.run(tell())


def test_without_a_robot_it_says_how_to_name_one(tmp_path: Path) -> None:
    said = subprocess.run([built("randomWalk", tmp_path)], capture_output=True, text=True, check=False)
    assert said.returncode == 1
    assert said.stderr.startswith("This program drives a robot; say which one: randomWalk --robot ws://HOST:9090")


def test_in_the_simulator_it_does_what_its_source_does(tmp_path: Path) -> None:
    binary = built("randomWalk", tmp_path)
    options = ["--world", "obstacles", "--seconds", "20", "--seed", "7"]
    hands = tmp_path / "hands.jsonl"
    hands.write_text('{"t": 2, "lift": "both"}\n{"t": 4, "lower": "both"}\n')
    traces: list[bytes] = []
    for program in (str(binary), str(ROOT / "examples" / "randomWalk" / "Main.hs")):
        trace = tmp_path / f"{len(traces)}.jsonl"
        assert main(["run", program, *options, "--input", str(hands), "--trace", str(trace)]) == 0
        traces.append(trace.read_bytes())
    assert traces[0] == traces[1]
    alone = subprocess.run([binary, *options], capture_output=True, text=True, check=False)
    assert alone.returncode == 1
    assert alone.stderr.strip().endswith(f"./rosy run {binary} {' '.join(options)}")


def test_a_program_with_a_mistake_is_not_built(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program, binary = tmp_path / "wrong.hs", tmp_path / "wrong"
    program.write_text("main = simulate (not 3)\n")
    assert main(["build", str(program), "-o", str(binary)]) == 1
    assert f"{program}:1:" in capsys.readouterr().out
    assert not binary.exists()
