"""./rosy build: native files that drive a robot behind a rosbridge server, here ours."""

from __future__ import annotations

import asyncio
import fcntl
import json
import os
import shutil
import struct
import subprocess
from collections.abc import Callable
from contextlib import redirect_stderr
from io import StringIO
from pathlib import Path

import pytest

from rosy_sim.cli import main
from rosy_sim.config import Config, discover
from rosy_sim.worker import native_build
from rosy_sim.worker.native_build import _newest

from ..web.page_client import opened, serving

ROOT = discover().root

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(
        _newest(ROOT, "dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-build/**/rosy-build") is None,
        reason="rosy-build is not built",
    ),
]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """An example as a native program, built when the first test asks for it, once for all processes of the runner."""
    # The processes of pytest-xdist have folders of their own in one folder.
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "built"
    folder.mkdir(exist_ok=True)

    def build(name: str) -> Path:
        binary = folder / name
        with (folder / f"{name}.lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not binary.exists():
                with redirect_stderr(StringIO()) as said:
                    status = main(["build", str(ROOT / "examples" / name / "Main.hs"), "-o", str(binary)])
                # Without what the linker says of functions that no program calls.
                assert (status, said.getvalue()) == (0, "")
        return binary

    return build


@pytest.mark.parametrize("name", ["accelerateAndPlay", "randomWalk"])
def test_a_built_program_drives_a_robot(name: str, built: Callable[[str], Path], config: Config) -> None:
    binary = built(name)

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            robot = f"ws://{address}/rosbridge/{hello['session']}?rearm=off"
            program = await asyncio.create_subprocess_exec(binary, "--robot", robot)
            try:
                await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [0.0])[0] > 0.1)
                await page.until(lambda m: m["op"] == "frame" and any(m["channels"].get("Bumper", [])))
            finally:
                program.terminate()
                await program.wait()
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [1.0])[0] == 0)

    asyncio.run(tell())


def test_it_drives_for_as_long_as_it_is_told(built: Callable[[str], Path], config: Config) -> None:
    binary = built("accelerateAndPlay")

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            robot = f"ws://{address}/rosbridge/{hello['session']}?rearm=off"
            program = await asyncio.create_subprocess_exec(binary, "--robot", robot, "--seconds", "4")
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [0.0])[0] > 0.1)
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [1.0])[0] == 0)
            assert await program.wait() == 0

    asyncio.run(tell())


def test_on_a_computer_without_rosy_it_says_what_it_can_do(built: Callable[[str], Path], tmp_path: Path) -> None:
    binary = built("accelerateAndPlay")
    elsewhere = {**os.environ, "ROSY_ROOT": str(tmp_path)}
    for options in ([], ["--world", "room"]):
        said = subprocess.run([binary, *options], capture_output=True, text=True, check=False, env=elsewhere)
        assert said.returncode == 1
        assert "Say which robot to drive: accelerateAndPlay --robot ws://HOST:9090" in said.stderr


def program_headers(binary: Path) -> set[int]:
    """Kinds of a 64-bit ELF file's program headers (elf(5))."""
    elf = binary.read_bytes()
    start, size, count = struct.unpack_from("<Q", elf, 32)[0], *struct.unpack_from("<HH", elf, 54)
    return {struct.unpack_from("<I", elf, start + size * i)[0] for i in range(count)}


PT_LOAD, PT_DYNAMIC, PT_INTERP = 1, 2, 3


def test_nothing_but_the_kernel_is_needed_to_start_it(built: Callable[[str], Path]) -> None:
    kinds = program_headers(built("accelerateAndPlay"))
    assert PT_LOAD in kinds
    assert not kinds & {PT_DYNAMIC, PT_INTERP}


@pytest.mark.skipif(shutil.which("bwrap") is None, reason="there is no bubblewrap for an empty root")
@pytest.mark.parametrize("host", ["127.0.0.1", "kitchen.local"])
def test_it_drives_a_robot_from_a_root_without_a_c_library(
    host: str, built: Callable[[str], Path], config: Config, tmp_path: Path
) -> None:
    """A name that is neither in /etc/hosts nor in DNS is asked of the machine's getent, here one that knows it."""
    binary = built("accelerateAndPlay")
    empty = tmp_path / "root"
    empty.mkdir()
    getent = tmp_path / "getent.c"
    getent.write_text('#include <stdio.h>\nint main(void) { puts("127.0.0.1 STREAM kitchen.local"); return 0; }\n')
    subprocess.run(["gcc", "-static", "-o", tmp_path / "getent", getent], check=True)
    sandbox = [
        "bwrap",
        "--bind",
        empty,
        "/",
        "--ro-bind",
        binary,
        "/walk",
        "--ro-bind",
        tmp_path / "getent",
        "/bin/getent",
    ]

    async def tell() -> None:
        async with serving(config) as (address, _), opened(address) as page:
            hello = await page.op("hello")
            robot = f"ws://{host}:{address.partition(':')[2]}/rosbridge/{hello['session']}?rearm=off"
            program = await asyncio.create_subprocess_exec(
                *map(str, sandbox),
                "--die-with-parent",
                "/walk",
                "--robot",
                robot,
                "--seconds",
                "4",
                env={"PATH": "/bin"},
            )
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [0.0])[0] > 0.1)
            await page.until(lambda m: m["op"] == "frame" and m["channels"].get("Velocity", [1.0])[0] == 0)
            assert await program.wait() == 0

    asyncio.run(tell())


@pytest.mark.skipif(shutil.which("bwrap") is None, reason="there is no bubblewrap for an empty root")
def test_a_name_that_no_one_knows_is_said_to_be_unknown(built: Callable[[str], Path], tmp_path: Path) -> None:
    sandbox = ["bwrap", "--bind", tmp_path, "/", "--ro-bind", built("accelerateAndPlay"), "/walk"]
    command = [*map(str, sandbox), "/walk", "--robot", "ws://kitchen.local:9090", "--seconds", "1"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env={"PATH": "/bin"}) as program:
        assert program.stderr is not None
        try:
            assert any("no computer here has this name" in line for line in program.stderr)
        finally:
            program.kill()


def test_without_a_static_c_library_it_says_what_the_program_needs(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    archive = native_build._archive
    monkeypatch.setattr(native_build, "_archive", lambda name: None if name == "libc.a" else archive(name))
    binary = tmp_path / "move"
    assert main(["build", str(ROOT / "examples" / "move" / "Main.hs"), "-o", str(binary)]) == 0
    assert "This computer has no static C library" in capfd.readouterr().err
    assert PT_INTERP in program_headers(binary)


@pytest.mark.long
def test_in_the_simulator_it_does_what_its_source_does(built: Callable[[str], Path], tmp_path: Path) -> None:
    binary = built("randomWalk")
    options = ["--world", "obstacles", "--seconds", "20", "--seed", "7"]
    hands = tmp_path / "hands.jsonl"
    hands.write_text('{"t": 2, "lift": "both"}\n{"t": 4, "lower": "both"}\n')
    source = str(ROOT / "examples" / "randomWalk" / "Main.hs")
    traces: list[bytes] = []
    for program in (["./rosy", "run", source], ["./rosy", "run", str(binary)], [str(binary)]):
        trace = tmp_path / f"{len(traces)}.jsonl"
        given = [*program, *options, "--input", str(hands), "--trace", str(trace)]
        said = subprocess.run(given, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
        assert json.loads(said.stdout)["ended"] == "time"
        traces.append(trace.read_bytes())
    assert traces[0] == traces[1] == traces[2]
    assert b'"Wheel' in traces[0], "hands lifted it"


def test_a_program_with_an_empty_place_is_not_built(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program, binary = tmp_path / "unfinished.hs", tmp_path / "unfinished"
    program.write_text("main = simulate (Velocity _ 0)\n")
    assert main(["build", str(program), "-o", str(binary)]) == 1
    assert f"{program}:1:27: warning: Something is missing here." in capsys.readouterr().out
    assert not binary.exists()


def test_a_program_with_a_mistake_is_not_built(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program, binary = tmp_path / "wrong.hs", tmp_path / "wrong"
    program.write_text("main = simulate (not 3)\n")
    assert main(["build", str(program), "-o", str(binary)]) == 1
    assert f"{program}:1:" in capsys.readouterr().out
    assert not binary.exists()


@pytest.mark.parametrize(("machine", "here", "wanted"), [("x86_64", "amd64", "arm64"), ("aarch64", "arm64", "amd64")])
def test_a_program_for_another_processor_is_refused_with_what_to_do(
    machine: str,
    here: str,
    wanted: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("platform.machine", lambda: machine)
    binary = tmp_path / "walk"
    assert main(["build", "my walk.hs", "-o", str(binary), "--for", wanted]) == 1
    said = capsys.readouterr().err
    assert f"for {here} only" in said
    assert wanted in said
    assert f"./rosy build 'my walk.hs' -o {binary}" in said


def test_the_processor_that_is_here_may_be_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("platform.machine", lambda: "aarch64")
    native_build.refuse_other_processor("arm64", Path("walk.hs"), Path("walk"))
