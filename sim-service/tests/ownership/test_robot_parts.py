"""Which of a program's types a robot does not have."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosy_sim.ownership.robot_parts import missing_parts


@pytest.mark.parametrize(
    ("address", "uses", "missing"),
    [
        ("ws://h", ["Bumper", "Led1", "Position"], []),
        ("ws://h?robot=create3", ["BumperLeft", "Cliff", "Led1", "Sound", "Velocity"], []),
        ("ws://h?robot=create3", ["AnalogInput", "RobotStatus"], ["AnalogInput", "RobotStatus"]),
        (
            "ws://h?ros=2&robot=turtlebot3",
            ["()", "BumperLeft", "Memory Int", "Position", "Sound", "String"],
            ["BumperLeft"],
        ),
        ("ws://h?robot=turtlesim", ["Led1", "Pose", "Velocity"], ["Led1"]),
        ("ws://h?robot=hoover", ["Bumper"], []),
        ("ws://h?robot=turtlebot3", ["Ahead", "Scan"], []),
        ("ws://h", ["Ahead", "Bumper", "Scan"], ["Ahead", "Scan"]),
        ("ros://h?scanner=on", ["Ahead", "Bumper", "Scan"], []),
        ("serial:/dev/kobuki?scanner=on", ["Ahead"], ["Ahead"]),
        ("ws://h?robot=create3&scanner=on", ["Ahead"], ["Ahead"]),
        ("ros://h?scanner=on", ["Pen", "PenColor", "PenWidth"], ["Pen", "PenColor", "PenWidth"]),
        ("ros://h?pen=on", ["Pen", "PenColor", "PenWidth"], []),
        ("serial:/dev/kobuki?pen=on", ["Pen"], ["Pen"]),
        ("ws://h?robot=turtlesim", ["Pen"], ["Pen"]),
        ("ros://h", ["LineSensor"], ["LineSensor"]),
        ("ros://h?line=on", ["LineSensor"], []),
    ],
)
def test_views_belong_to_their_channel(address: str, uses: list[str], missing: list[str]) -> None:
    assert missing_parts(address, uses) == missing


def test_a_profile_names_the_robot(tmp_path: Path) -> None:
    file = tmp_path / "profile.json"
    file.write_text('{"robot": "turtlebot3"}')
    assert missing_parts(f"ws://h?profile={file}", ["Bumper"]) == ["Bumper"]
    assert missing_parts(f"ws://h?profile={file}&robot=kobuki", ["Bumper"]) == []


def test_a_profile_says_that_there_is_a_scanner(tmp_path: Path) -> None:
    file = tmp_path / "profile.json"
    file.write_text('{"scanner": true}')
    assert missing_parts(f"ws://h?profile={file}", ["Ahead"]) == []
    assert missing_parts(f"ws://h?profile={file}&scanner=off", ["Ahead"]) == ["Ahead"]
