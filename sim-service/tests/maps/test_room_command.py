"""``./rosy room``: the file it writes is a room that programs run in, what it says, and its mistakes."""

from __future__ import annotations

import json
from pathlib import Path

from rosy_sim.worlds.gallery import load_world

from ..test_cli import Here, environment, here, last, rosy
from .drawn_map import binary, map_file, put, rectangle

__all__ = ["environment", "here"]

ROOM = put(rectangle(60, 40), 10, 10, ["#"])


def test_a_program_runs_in_the_room_of_a_map(environment: dict[str, str], tmp_path: Path) -> None:
    map_file(tmp_path / "maps", binary(ROOM), origin="[-1.5, -1.0, 0]")
    done = rosy(environment, "room", "maps/scan.yaml", "-o", "classroom.json")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "classroom.json: 3 by 2 m, 4 walls; the robot starts at (1.5, 1).",
        "Left out, because they have fewer than 3 cells: 1.",
    ]
    (tmp_path / "p.hs").write_text("drive:0.3")
    run = rosy(environment, "run", "p.hs", "--world", "classroom.json", "--seconds", 10, "--seed", 1)
    assert (run.returncode, run.stderr) == (0, "")
    pose = last(run)["pose"]
    assert isinstance(pose, dict)
    # As far as the body lets it: the wall begins at 2.95 m.
    assert abs(pose["x"] + 0.1765 - 2.95) < 0.01


def test_the_room_is_beside_its_map_unless_it_is_named(here: Here, tmp_path: Path) -> None:
    map_file(tmp_path / "maps", binary(ROOM))
    assert here("room", "maps/scan.yaml").returncode == 0
    world = load_world(str(tmp_path / "maps/scan.json"))
    assert world["name"] == "scan"
    assert json.loads((tmp_path / "maps/scan.json").read_text()) == world


def test_a_mistake_is_one_sentence_and_no_file(here: Here, tmp_path: Path) -> None:
    map_file(tmp_path, binary(ROOM)[:-1])
    done = here("room", "scan.yaml")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "rosy: The image scan.pgm is damaged or cut short.\n"
    assert not (tmp_path / "scan.json").exists()
    assert here("room").stderr.count("\n") == 1
    assert here("room", "scan.yaml", "--size", "3").returncode == 1
