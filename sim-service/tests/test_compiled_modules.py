"""Compiled modules: when they are taken, and that a run is the same to the last byte with and without them."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from rosy_sim import compiled_modules
from rosy_sim.compiled_modules import MODULES, SOURCES, fingerprint, install, source_of

COMPILED = Path(compiled_modules.__file__).parents[2] / ".rosy" / "compiled"

_is_compiled = (COMPILED / SOURCES).exists() and (COMPILED / SOURCES).read_text() == fingerprint()

_RUNS = """
import hashlib, io, json, math, random, socket, sys, threading
from pathlib import Path
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_over_link
from rosy_sim.run.steps import lockstep
from rosy_sim.run.steps.hands import read_hands
from rosy_sim.run.steps.velocity_guard import SafetySettings
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import Press, Teleport
from rosy_sim.world.world import World
from rosy_sim.worlds.gallery import named_world, world_names

sys.path.insert(0, sys.argv[1])
from tests.fake_program import play

found = hashlib.sha256()
for name in world_names():
    for seed, realistic in ((1, False), (2, True)):
        room = dict(named_world(name))
        if realistic:
            room["realism"] = {"slip": 0.1, "latency": 0.1}
        for script in (
            "drive:0.5 turn:0.7 led:2@3 say:hi@5", "tour bump", "fight drive:0.3 error@200", "turn:2.0 drip garble@30"
        ):
            world = World(read_arena(room), KOBUKI, seed)
            ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
            program = threading.Thread(target=play, args=(theirs, script))
            program.start()
            trace, said = io.BytesIO(), []
            hands = ((0.5, Press(1, True)), (0.7, Press(1, False)), (1.5, Teleport((1.0, 1.0, 0.3))))
            settings = RunSettings(6.0, seed, None, hands, safety=SafetySettings(on=realistic))
            result = run_over_link(ours, world, settings, RunOutput(said.append, trace))
            ours.close()
            program.join()
            problems = [problem.message for problem in result.problems]
            told = (result.ended, result.steps, problems, said, world.channels())
            found.update(trace.getvalue() + repr(told).encode())
print(lockstep.__file__)
print(found.hexdigest())
"""


def _runs(compiled: str) -> tuple[str, str]:
    """Which file was used, and a digest of all that happened."""
    folder = str(Path(__file__).parents[1])
    environment = {**os.environ, "ROSY_COMPILED": compiled, "PYTHONPATH": folder}
    done = subprocess.run(
        [sys.executable, "-c", _RUNS, folder], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    file, digest = done.stdout.split()
    return file, digest


def _classes(source: Path) -> list[ast.ClassDef]:
    return [node for node in ast.walk(ast.parse(source.read_text())) if isinstance(node, ast.ClassDef)]


def test_no_class_of_another_module_inherits_from_one_that_is_compiled() -> None:
    # Such a class is refused when it is made, or its first object.
    package = Path(compiled_modules.__file__).parent
    compiled = {source_of(name) for name in MODULES}
    bases = {one.name for source in compiled for one in _classes(source)}
    others = [source for source in package.rglob("*.py") if source not in compiled]
    heirs = [one.name for source in others for one in _classes(source) if bases & {ast.unparse(b) for b in one.bases}]
    assert heirs == []


@pytest.mark.skipif(not _is_compiled, reason="the modules are not compiled here")
def test_a_run_is_the_same_to_the_last_byte_whether_its_modules_are_compiled_or_not() -> None:
    compiled, interpreted = _runs("on"), _runs("off")
    assert compiled[0].endswith(EXTENSION_SUFFIXES[0])
    assert interpreted[0].endswith("lockstep.py")
    assert compiled[1] == interpreted[1]


def test_what_was_to_be_compiled_was_compiled() -> None:
    # No folder: not attempted. A folder without the file: it failed, and `./rosy` continued with the sources.
    assert not COMPILED.is_dir() or (COMPILED / SOURCES).is_file(), "see .rosy/log/compiled.log"


def test_modules_of_other_sources_are_not_taken(tmp_path: Path) -> None:
    before = list(sys.meta_path)
    assert not install(tmp_path / "nothing")
    (tmp_path / SOURCES).write_text("of others")
    assert not install(tmp_path)
    # The library is missing.
    (tmp_path / SOURCES).write_text(fingerprint())
    assert not install(tmp_path)
    # It is none.
    (tmp_path / f"a__mypyc{EXTENSION_SUFFIXES[0]}").write_bytes(b"text")
    assert not install(tmp_path)
    assert sys.meta_path == before


@pytest.mark.parametrize("name", MODULES)
def test_a_module_has_a_source_that_can_be_compiled(name: str) -> None:
    text = source_of(name).read_text()
    # A library looks into such a class while it is made; a place of its own says where a file is.
    assert "msgspec.Struct" not in text
    assert "__file__" not in text
    # Two exceptions of different types in one function need different names: a name has one type when it is compiled.
    for function in re.split(r"\n    def |\ndef ", text):
        named = re.findall(r"except (.+) as (\w+):", function)
        assert len({variable for _, variable in named}) == len(named), named
