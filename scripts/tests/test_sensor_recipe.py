"""
The recipe for a sensor in CONTRIBUTING.md, followed in a scratch copy: a sensor for the current of the wheels' motors, and a program
that uses it in the simulator; and one type of each role, which everything that depends on roles must know afterwards.

The copy's library is interpreted, so nothing is built; `npm run environment`, which needs the built library, is left out.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from languages import languages
from robot_descriptions import Vocabulary, merged, robots

ROOT = Path(__file__).resolve().parents[2]

COPIED = [
    "protocol/robots",
    "scripts",
    "rosy-hs/src",
    "rosy-hs/worker/Rosy/Worker/Explanation",
    "rosy-hs/LANGUAGE.md",
    "rosy-hs/ros/msg",
    "sim-service/rosy_sim",
    "languages",
    "codegen/src/robot",
]

DESCRIPTION = "protocol/robots/kobuki.json"
DEVICE = "sim-service/rosy_sim/robots/kobuki/motor_current.py"
DEVICES = "sim-service/rosy_sim/robots/kobuki/__init__.py"

TYPE = {
    "name": "MotorCurrent",
    "doc": "The current of the left and the right motor, in A.",
    "fields": [
        {"name": "currentLeft", "type": "Double", "unit": "A", "doc": "Of the left motor."},
        {"name": "currentRight", "type": "Double", "unit": "A", "doc": "Of the right motor."},
    ],
    "labels": {
        "en": {
            "parts": ["left, amperes", "right, amperes"],
            "tooltip": "The current of the motors.",
            "noun": "a motor current",
            "toolbox": "when it has a motor current",
        },
        "de": {
            "parts": ["links, Ampere", "rechts, Ampere"],
            "tooltip": "Der Strom der Motoren.",
            "noun": "ein Motorstrom",
            "toolbox": "wenn es einen Motorstrom hat",
        },
        "pt": {
            "parts": ["esquerda, ampères", "direita, ampères"],
            "tooltip": "A corrente dos motores.",
            "noun": "uma corrente dos motores",
            "toolbox": "quando ele tem uma corrente dos motores",
        },
        "es": {
            "parts": ["izquierda, amperios", "derecha, amperios"],
            "tooltip": "La corriente de los motores.",
            "noun": "una corriente de los motores",
            "toolbox": "cuando tiene una corriente de los motores",
        },
        "fr": {
            "parts": ["gauche, ampères", "droite, ampères"],
            "tooltip": "Le courant des moteurs.",
            "noun": "un courant de moteur",
            "toolbox": "quand il a un courant de moteur",
        },
    },
    "toolbox": {"function": "effort", "parts": ["left", "right"]},
}

CHANNEL = {
    "name": "MotorCurrent",
    "kind": "state",
    "ros": {
        "topic": "{prefix}/sensors/core",
        "type": "{messages}/SensorState",
        "fields": [{"path": "current.0", "scale": 0.01}, {"path": "current.1", "scale": 0.01}],
    },
    "serial": {"packet": 6, "fields": [{"byte": 0, "width": "u8", "scale": 0.01}, {"byte": 1, "width": "u8", "scale": 0.01}]},
    "source": "kobuki_driver, Protocol Specification, Current: 10 mA",
}

CHART = {
    "key": "currentLeft",
    "channel": "MotorCurrent",
    "place": 0,
    "unit": "A",
    "color": "state",
    "labels": {"en": "Left motor", "de": "Linker Motor", "pt": "Motor esquerdo", "es": "Motor izquierdo", "fr": "Moteur gauche"},
}

DEVICE_CODE = '''"""Current of the motors: some to stand, more the faster they turn."""

from ...world.arena import Arena
from ...world.robot import Surroundings


class MotorCurrent:
    events: frozenset[str] = frozenset()

    def __init__(self, arena: Arena) -> None:
        pass

    def integrate(self, robot: Surroundings, dt: float) -> None:
        pass

    def values(self, robot: Surroundings) -> dict[str, tuple[float | int | str, ...]]:
        return {"MotorCurrent": (0.1 + robot.v, 0.1 + robot.v)}
'''

PROGRAM = """import Rosy
import Rosy.Launch (onPipe)
import Foreign.Ptr (nullPtr)
import System.Environment (getArgs)

effort :: MotorCurrent -> Maybe Say
effort (MotorCurrent left _) = if left > 0.5 then Just (Say (show (round (left * 10) :: Int))) else Nothing

main :: IO ()
main = do
  [_, descriptor] <- getArgs
  onPipe (read descriptor) nullPtr nullPtr [] [] (simulate (Velocity 0.5 0, effort))
"""

RUN = """
import sys
from pathlib import Path
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_native
from rosy_sim.config import Limits
from rosy_sim.world.arena import read_arena
from rosy_sim.world.world import World

world = World(read_arena({"size": [9, 9], "start": {"x": 2, "y": 4}}), KOBUKI)
result = run_native(Path(sys.argv[1]), world, RunSettings(1.0, 1, limits=Limits(settle=300, ready=300)), RunOutput(say=print))
print(result.ended, [problem.message for problem in result.problems])
"""


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The parts of the repository that the recipe touches."""
    for part in COPIED:
        if (ROOT / part).is_file():
            (tmp_path / part).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / part, tmp_path / part)
        else:
            shutil.copytree(ROOT / part, tmp_path / part, ignore=shutil.ignore_patterns("__pycache__", "tests"))
    return tmp_path


def run(copy: Path, *command: str) -> str:
    """What a command in the copy prints; it must succeed."""
    done = subprocess.run(
        command, cwd=copy, env={**os.environ, "ROSY_ROOT": str(copy), "PYTHONPATH": str(copy / "sim-service")}, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def follow_recipe(copy: Path) -> None:
    """The files that are written by hand, and the generator."""
    description: dict[str, Any] = json.loads((copy / DESCRIPTION).read_text())
    description["types"].append(TYPE)
    description["channels"].append(CHANNEL)
    description["charts"].append(CHART)
    (copy / DESCRIPTION).write_text(json.dumps(description))
    (copy / DEVICE).write_text(DEVICE_CODE)
    devices = (copy / DEVICES).read_text()
    changed = re.sub(r"devices=\(", "devices=(MotorCurrent, ", devices).replace(
        "from .power import", "from .motor_current import MotorCurrent\nfrom .power import"
    )
    assert changed.count("MotorCurrent") == 2
    (copy / DEVICES).write_text(changed)
    run(copy, sys.executable, "scripts/robots.py")


def test_the_recipe_names_the_files_that_it_takes() -> None:
    recipe = next(line for line in (ROOT / "CONTRIBUTING.md").read_text().split("\n- ") if line.startswith("**A sensor or command:**"))
    for named in [DESCRIPTION, DEVICE.replace("motor_current", "<name>"), "`__init__.py` there", "scripts/robots.py", Path(__file__).name]:
        assert named in recipe


def test_a_program_uses_a_sensor_that_was_added_by_the_recipe(copy: Path) -> None:
    follow_recipe(copy)
    labels = (copy / "languages/de/blocks/robot.generated.ts").read_text()
    assert "Der Strom der Motoren." in labels
    assert "Linker Motor" in labels
    (copy / "Main.hs").write_text(PROGRAM)
    program = copy / "program"
    program.write_text(f'#!/bin/sh\nexec runghc --ghc-arg=-package-env=- --ghc-arg=-i{copy}/rosy-hs/src {copy}/Main.hs "$@"\n')
    program.chmod(0o755)
    *said, ended = run(copy, sys.executable, "-c", RUN, str(program)).splitlines()
    assert ended == "time []"
    # The sensor follows the speed: 0.5 m/s gives 0.6 A.
    assert said[-1] == "6"


LANGUAGES = languages()

ROLES = {"event": "Knocked", "state": "Humidity", "command": "Fan"}
"""A type of each role. The fan lasts, so its label says what it sets."""


def add_roles(copy: Path) -> None:
    """A channel of each role with one number, and the generator."""
    description: dict[str, Any] = json.loads((copy / DESCRIPTION).read_text())
    for role, name in ROLES.items():
        labels: dict[str, Any] = {"parts": ["level"], "tooltip": f"{name}.", "noun": f"a {name}"}
        if role == "command":
            labels["actuator"] = "the fan"
        description["types"].append(
            {
                "name": name,
                "doc": f"A type of the role {role}.",
                "fields": [{"name": f"level{name}", "type": "Double", "doc": "How much."}],
                "labels": dict.fromkeys(LANGUAGES, labels),
            }
        )
        ros = {"topic": f"/{name.lower()}", "type": "std_msgs/Float64", "fields": ["data"]}
        description["channels"].append({"name": name, "kind": role, "ros": ros, **({"rest": [0]} if role == "command" else {})})
    (copy / DESCRIPTION).write_text(json.dumps(description))
    run(copy, sys.executable, "scripts/robots.py")


def table(text: str, name: str) -> str:
    """A table of generated TypeScript."""
    return text.split(f'"{name}": [')[1].split("]")[0]


def test_a_type_of_each_role_is_known_wherever_roles_matter(copy: Path) -> None:
    add_roles(copy)
    event, state, command = ROLES.values()
    # The page and the blocks.
    roles = (copy / "codegen/src/robot/description.generated.ts").read_text().split('"roles"')[1]
    for name, of in (("events", event), ("states", state), ("commands", command), ("held", command)):
        assert f'"{of}"' in table(roles, name)
        assert all(f'"{other}"' not in table(roles, name) for other in ROLES.values() if other != of)
    for language in LANGUAGES:
        words = (copy / f"languages/{language}/blocks/robot.generated.ts").read_text()
        assert f'"{command}": "the fan"' in words.split('"actuators"')[1]
    # The service's explanations.
    told = run(copy, sys.executable, "-c", "from rosy_sim.robot_description import type_roles; print(*type_roles()[:3], sep='\\n')").splitlines()
    assert [state in told[0], command in told[1], command in told[2]] == [True] * 3
    assert event not in "".join(told)
    # The worker's explanations, and the reference.
    explanations = (copy / "rosy-hs/worker/Rosy/Worker/Explanation/RobotTypes.hs").read_text()
    for name, of in (("commandTypes", {command}), ("commandOnly", {command}), ("sensedOnly", {event, state})):
        line = explanations.split(f"{name} =")[1].split("]")[0]
        assert {type_ for type_ in ROLES.values() if f'"{type_}"' in line} == of
    terms = (copy / "rosy-hs/LANGUAGE.md").read_text().split("## Terms")[1].split("\n## ")[0].splitlines()
    for term, of in (("Event", event), ("State", state), ("Command", command)):
        assert [line for line in terms if f"`{of}`" in line] == [line for line in terms if line.startswith(f"- **{term}**")]


def test_the_reference_names_every_exported_type() -> None:
    exports = (ROOT / "rosy-hs/src/Rosy.hs").read_text().split("\n  )\nwhere")[0]
    exported = set(re.findall(r"^    ([A-Z]\w*)(?: \(.*\))?,$", exports, re.MULTILINE)) - {"World"}
    terms = (ROOT / "rosy-hs/LANGUAGE.md").read_text().split("## Terms")[1].split("\n## ")[0]
    assert exported - set(re.findall(r"`(\w+)`", terms)) == set()


SOURCES = [
    ("codegen/src", "*.ts"),
    ("editor/src", "*.ts"),
    ("editor/src", "*.tsx"),
    ("sim-service/rosy_sim", "*.py"),
    ("rosy-hs/worker", "*.hs"),
    ("rosy-hs/src", "*.hs"),
    ("rosy-hs/robots", "*.hs"),
]

OTHER_LISTS = {
    "editor/src/features/runs/differences.ts": "what a robot feels of the room, which simulation and reality compare",
    "editor/src/features/shared_page/film.ts": "what the drawing of a robot shows, so that a film has nothing else",
    "sim-service/rosy_sim/run/steps/velocity_guard.py": "the safety rules are about contact and holes (rule R24)",
    "rosy-hs/worker/Rosy/Worker/Explanation/TextualMistakes/Numbers.hs": "units behind the numbers of drive, turn and wait",
    "rosy-hs/worker/Rosy/Worker/Explanation/MissingInstances.hs": "types with numbers inside, which a pattern takes out",
    "rosy-hs/worker/Rosy/Worker/Explanation/ArgumentCounts.hs": "types with numbers inside, whose patterns stand in brackets",
}
"""Lists that are not about a role, each with what it is about."""


def test_no_list_of_types_is_kept_by_hand() -> None:
    """A literal with three types of one role is a list of that role, or has its reason above."""
    types, channels = merged(robots(), "types"), merged(robots(), "channels")
    roles = Vocabulary(types).roles(channels)
    role_of = {"event": set(roles.events), "state": set(roles.states), "command": set(roles.commands)}
    found = set()
    for folder, pattern in SOURCES:
        for file in (ROOT / folder).rglob(pattern):
            where = str(file.relative_to(ROOT))
            if "/words/" in where or re.search("[Gg]enerated", file.read_text()[:1500]):
                continue
            for literal in re.findall(r"[\[({]([^\[\](){}]*)[\])}]", file.read_text()):
                named = set(re.findall(r"[\"'` ](\w+)(?=[\"'` ])", literal)) if re.search(r"[\"'`]", literal) else set()
                if any(len(named & names) >= 3 for names in role_of.values()):
                    found.add(where)
    assert found == set(OTHER_LISTS)
