"""The simulated base is fitted to a recorded one: the numbers of a base whose slip is known, what cannot be told."""

from __future__ import annotations

import argparse
import json
import math
import re
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput
from rosy_sim.recordings.command import replay_recording
from rosy_sim.recordings.fit import Fit, Moved, RecordedDrive, Told, recorded_drive
from rosy_sim.recordings.fit import fit as fitted
from rosy_sim.recordings.link_log import LinkLine
from rosy_sim.recordings.mcap_file import open_recording
from rosy_sim.robots.kobuki import KOBUKI
from rosy_sim.world.arena import read_arena
from rosy_sim.world.events import velocity
from rosy_sim.world.realism import Realism
from rosy_sim.world.time_step import STEP
from rosy_sim.world.world import World

from .stand_in_base import recorded, recorded_at, ros2_robot

# Seconds, m/s, rad/s.
SQUARES = [(2.0, 0.3, 0.0), (1.5, 0.0, 1.0), (2.0, -0.2, 0.0), (1.0, 0.0, -1.5), (2.0, 0.3, 0.5), (1.0, 0.0, 0.0)]


def fit(drive: RecordedDrive) -> Fit:
    return fitted(drive, KOBUKI.limits)


def driven(parts: list[tuple[float, float, float]] = SQUARES, **realism: float) -> RecordedDrive:
    """The simulated robot drives, and its odometry is recorded."""
    room = {"size": [40, 40], "start": {"x": 20, "y": 20, "theta": 1.0}, "realism": realism}
    world = World(read_arena(room), KOBUKI, 1)
    drive, time = RecordedDrive([], [], []), 0.0
    for seconds, v, w in parts:
        for _ in range(round(seconds / STEP)):
            x, y, theta, _, _ = world.odometry()
            drive.moved.append(Moved(time, x, y, math.remainder(theta, 2 * math.pi)))
            drive.told.append(Told(time, v, w))
            world.command(velocity(v, w))
            world.integrate()
            time += STEP
    return drive


@pytest.mark.parametrize(
    ("travel", "turning", "veer", "latency"),
    [(1.0, 1.0, 0.0, 0.0), (0.8, 0.9, 0.0, 0.1), (1.1, 0.7, 0.3, 0.2), (0.9, 1.2, -0.4, 0.0)],
)
def test_the_numbers_of_the_simulated_base_are_found_again(
    travel: float, turning: float, veer: float, latency: float
) -> None:
    found = fit(driven(travel=travel, turning=turning, veer=veer, latency=latency))
    assert (found.travel, found.turning) == pytest.approx((travel, turning), rel=0.01)
    assert found.veer == pytest.approx(veer, abs=0.01)
    assert found.latency == pytest.approx(latency, abs=STEP)


def test_noise_of_slipping_wheels_hides_little() -> None:
    found = fit(driven(SQUARES * 3, travel=0.8, turning=0.9, veer=0.3, drift=0.02))
    assert (found.travel, found.turning, found.veer) == pytest.approx((0.8, 0.9, 0.3), rel=0.1)


def test_a_command_or_odometry_that_comes_late_now_and_then_changes_little() -> None:
    drive = driven(SQUARES * 3, travel=0.8, turning=0.7, veer=0.3)
    # Of eight changes of the velocity two reach the wheels a quarter of a second later than they are recorded.
    changes = [i for i in range(1, len(drive.told)) if drive.told[i][1:] != drive.told[i - 1][1:]]
    told = list(drive.told)
    for change in changes[::4]:
        for i in range(change - 12, change):
            told[i] = told[i]._replace(v=told[change].v, w=told[change].w)
    found = fit(RecordedDrive(told, drive.moved, []))
    assert (found.travel, found.turning, found.veer) == pytest.approx((0.8, 0.7, 0.3), rel=0.03)


def test_what_was_not_driven_is_not_told() -> None:
    assert fit(RecordedDrive([], [], [])).realism() == {}
    assert fit(driven([(3.0, 0.0, 0.0)])).realism() == {}
    ahead = fit(driven([(4.0, 0.3, 0.0)], travel=0.9, veer=0.2))
    assert ahead.turning is None
    assert (ahead.travel, ahead.veer) == pytest.approx((0.9, 0.2), rel=0.02)
    spin = fit(driven([(4.0, 0.0, 1.0)], turning=0.9))
    assert (spin.travel, spin.veer) == (None, None)
    assert spin.turning == pytest.approx(0.9, rel=0.02)
    # On one arc a weak turn and a pull to one side are the same.
    arc = fit(driven([(6.0, 0.3, 0.5)], travel=0.9, turning=0.9))
    assert arc.veer is None
    assert arc.turning == pytest.approx(0.9, rel=0.02)


def test_what_no_room_can_have_is_limited_and_told() -> None:
    drive = driven(SQUARES * 3, travel=0.2)
    slow = fit(RecordedDrive(drive.told, [m._replace(x=m.x / 2, y=m.y / 2) for m in drive.moved], []))
    assert slow.travel == pytest.approx(0.1, rel=0.1)
    assert slow.realism()["travel"] == 0.2
    assert slow.beyond() == {"travel": 0.2}
    assert fit(driven(SQUARES * 3, travel=0.8)).beyond() == {}


def test_what_holds_the_robot_says_nothing_about_its_wheels() -> None:
    drive = driven(SQUARES * 2, travel=0.8)
    # For two seconds it stands before a wall, and its bumper is pressed.
    stood = [m if not 3.5 <= m.time <= 5.5 else drive.moved[175] for m in drive.moved]
    held = RecordedDrive(drive.told, stood, [(3.5, 5.5)])
    assert fit(held).travel == pytest.approx(0.8, rel=0.05)


def test_wheels_and_odometry_are_read_from_the_lines_of_a_recording() -> None:
    def line(time: float, source: str, topic: str, msg: object) -> LinkLine:
        published = msgspec.json.encode({"op": "publish", "topic": topic, "msg": msg})
        return msgspec.convert((round(time * 1e9), source, published), LinkLine)

    half = math.sin(0.3)
    pose = {"position": {"x": 1, "y": 2}, "orientation": {"z": half, "w": math.cos(0.3)}}
    bumper = "/mobile_base/events/bumper"
    twist = {"linear": {"x": 0.2}, "angular": {"z": 0.1}}
    found = recorded_drive(
        [
            line(1, "from_program", "/mobile_base/commands/velocity", twist),
            line(2, "to_robot", "/mobile_base/commands/velocity", twist),
            line(3, "to_program", "/odom", {"pose": {"pose": pose}}),
            line(4, "to_program", bumper, {"bumper": 1, "state": 1}),
            line(5, "to_program", bumper, {"bumper": 1, "state": 0}),
            line(6, "to_program", bumper, {"bumper": 0, "state": 1}),
            line(7, "to_program", "/odom", {"pose": 7}),
            LinkLine(8_000_000_000, "to_program", b"{"),
        ]
    )
    assert found.told == [Told(2, 0.2, 0.1)]
    [moved] = found.moved
    assert moved == pytest.approx((3, 1, 2, 0.6))
    assert found.held == [(4, 5), (6, 8)]


def odometry(x: float, theta: float) -> str:
    pose = {
        "position": {"x": x, "y": 0.0, "z": 0.0},
        "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(theta / 2), "w": math.cos(theta / 2)},
    }
    still = {"linear": dict.fromkeys("xyz", 0.0), "angular": dict.fromkeys("xyz", 0.0)}
    return json.dumps({"child_frame_id": "base_link", "pose": {"pose": pose}, "twist": {"twist": still}})


@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
@pytest.mark.parametrize("robot", ["create3", "turtlebot3"])
def test_a_recording_of_a_ros_2_robot_tells_the_same(config: Config, robot: str) -> None:
    """The robot link uses the same topics and messages for every robot, independent of those of the robot itself."""

    drove: list[str] = []

    def act(line: str, say: Callable[[str], None]) -> None:
        if line.startswith("port"):
            say(f"stream /odom {odometry(5.0, 0.5)}")
        elif line.startswith("got /cmd_vel") and '"x": 0.2' in line and not drove:
            drove.append(line)
            say(f"stream /odom {odometry(5.5, 1.0)}")
            if robot == "create3":
                say("hazard 1 bump_front_center on")

    with ros2_robot(robot, act) as address:
        path = recorded_at(address, config, "drive:0.2 done@150").path
    with open_recording(path) as recording:
        found = recorded_drive(recording.lines())
    assert {(told.v, told.w) for told in found.told} >= {(0.2, 0.0), (0.0, 0.0)}
    # From where the run began, with the first heading along x.
    assert (found.moved[0].x, found.moved[0].theta) == pytest.approx((0, 0))
    # The stand-in goes on to say where it was before, too.
    turned = max(found.moved, key=lambda moved: moved.theta)
    assert (math.hypot(turned.x, turned.y), turned.theta) == pytest.approx((0.5, 0.5), abs=0.001)
    assert len(found.held) == (1 if robot == "create3" else 0)


def test_the_inverse_of_what_wheels_do_is_what_they_were_told() -> None:
    realism = Realism(travel=0.8, turning=1.2, veer=0.3)
    assert realism.told(*realism.turned(0.4, -0.7)) == pytest.approx((0.4, -0.7))


SLIP = (0.8, 0.7, 0.3)


@pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")
def test_the_slip_of_a_base_is_noticed_and_its_room_written(
    config: Config, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In real time: how well it is found depends on when messages come; the test above judges that, without a clock."""
    path = recorded(config, "tour done@450", tmp_path, told=f"slip {' '.join(map(str, SLIP))}").path
    room = tmp_path / "fitted.json"
    options = argparse.Namespace(file=path, program=None, fit=True, world="table", output=room)
    assert replay_recording(config, options, lambda sentence: print(sentence), lambda _, __: None) == 0
    written = json.loads(room.read_bytes())
    found = written["realism"]
    with open_recording(path) as recording:
        assert found == fit(recorded_drive(recording.lines())).realism()
    assert found["travel"] < 0.95
    assert found["turning"] < 0.95
    assert found["veer"] > 0
    assert written["name"] == "fitted"
    said = capsys.readouterr().out
    assert re.search(r"^travel [\d.]+: it drove \d+ % of the way", said)
    assert f"{room}: the room table with such a robot" in said
    # The simulated robot now drives like the real one.
    world = World(read_arena(written), KOBUKI)
    assert world.arena.realism is not None
    assert world.arena.realism.turning == found["turning"]


def test_a_run_that_drives_too_little_and_wrong_options_are_refused(config: Config, tmp_path: Path) -> None:
    if discover().robot_executable is None:
        pytest.skip("rosy-robot is not built")
    path = recorded(config, "say:hi@4 done@20", tmp_path).path

    def replayed(**more: object) -> None:
        options = argparse.Namespace(
            **{"file": path, "program": None, "fit": True, "world": None, "output": None, **more}
        )
        replay_recording(config, options, lambda _: None, lambda _, __: None)

    with pytest.raises(BadInput, match=r"to tell how it drives, it takes 0\.3 m or 60°"):
        replayed()
    with pytest.raises(BadInput, match="takes no program"):
        replayed(program=tmp_path / "my.hs")
    with pytest.raises(BadInput, match="are for --fit"):
        replayed(fit=False, world="table")
    with pytest.raises(BadInput, match="no world called"):
        replayed(world="nowhere")
