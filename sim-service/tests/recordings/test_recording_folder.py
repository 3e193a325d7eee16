"""The folder of recordings: bounded, private, and complete after a crash."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import pytest
from mcap.reader import make_reader

from rosy_sim.errors import BadInput
from rosy_sim.recordings.__main__ import main
from rosy_sim.recordings.mcap_file import RunDetails, open_recording
from rosy_sim.recordings.recording_folder import (
    Finished,
    PendingRecording,
    RecordingFolder,
    finish_left,
    named_recording,
    recorded_sentence,
)

DETAILS = RunDetails("main = simulate (Velocity 0.1 0)", "serial:/dev/kobuki", "pupils/anna's walk.hs")

LOG = b"""1000 > {"op":"start","seed":3}
900 < {"op":"ready"}
1001 > {"op":"publish","topic":"/odom","msg":{"x":1}}
. 2
"""


def recorded(folder: RecordingFolder, log: bytes = LOG) -> Finished | None:
    pending = folder.begin(DETAILS)
    pending.log.write_bytes(log)
    return pending.finish(DETAILS)


def test_a_recording_is_its_owners_and_named_after_time_and_program(tmp_path: Path) -> None:
    finished = recorded(RecordingFolder(tmp_path / "recordings"))
    assert finished is not None
    assert finished.path.name.endswith("-anna-s-walk.mcap")
    assert (finished.path.stat().st_mode & 0o777, finished.path.parent.stat().st_mode & 0o777) == (0o600, 0o700)
    assert [path.name for path in finished.path.parent.iterdir()] == [finished.path.name]


def test_another_reader_finds_order_times_program_and_details(tmp_path: Path) -> None:
    finished = recorded(RecordingFolder(tmp_path))
    assert finished is not None
    with finished.path.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        found = [(c.topic, m.log_time, m.data) for _, c, m in reader.iter_messages()]
        assert found == [
            ("/rosy/to_program", 1000, b'{"op":"start","seed":3}'),
            ("/rosy/from_program", 1001, b'{"op":"ready"}'),
            (
                "/odom",
                1002,
                b'{"header":{"stamp":{"sec":0,"nanosec":1002},"frame_id":"odom"},"child_frame_id":"base_footprint","x":1}',
            ),
        ]
        assert [a.data.decode() for a in reader.iter_attachments()] == [DETAILS.program]
        assert [m.metadata for m in reader.iter_metadata()] == [
            {
                "version": "1",
                "robot": DETAILS.robot,
                "name": DETAILS.name,
                "ended": "",
                "complete": "yes",
                "left_out": "2",
            }
        ]


def test_runs_in_the_same_second_have_names_of_their_own(tmp_path: Path) -> None:
    folder = RecordingFolder(tmp_path)
    assert len({finished.path for _ in range(5) if (finished := recorded(folder))}) == 5


def test_the_oldest_make_room_which_is_said(tmp_path: Path) -> None:
    first = recorded(RecordingFolder(tmp_path))
    assert first is not None
    os.utime(first.path, (1, 1))
    size = first.path.stat().st_size
    second = recorded(RecordingFolder(tmp_path, most=2 * size + size // 2))
    assert second is not None
    assert second.removed == 0
    third = recorded(RecordingFolder(tmp_path, most=2 * size + size // 2))
    assert third is not None
    assert third.removed == 1
    assert set(tmp_path.iterdir()) == {second.path, third.path}
    assert "Old recordings made room for it: 1." in str(recorded_sentence(third))


def test_the_newest_stays_even_when_it_is_too_large_alone(tmp_path: Path) -> None:
    finished = recorded(RecordingFolder(tmp_path, most=10))
    assert finished is not None
    assert finished.path.exists()


def test_a_run_that_never_reached_its_robot_leaves_nothing(tmp_path: Path) -> None:
    assert recorded(RecordingFolder(tmp_path), b"") is None
    assert list(tmp_path.iterdir()) == []


def killed(pending: PendingRecording) -> PendingRecording:
    """A recording whose process is gone in the middle of a line."""
    pending.log.write_bytes(LOG[:-5] + b'\n1002 > {"op":"st')
    return replace(pending, lock=None)


def test_a_log_that_a_crash_left_becomes_a_recording_after_the_next_run(tmp_path: Path) -> None:
    folder = RecordingFolder(tmp_path)
    left = killed(folder.begin(DETAILS))
    running = folder.begin(DETAILS)
    recorded(folder)
    assert not left.log.exists()
    assert running.log.exists()
    with open_recording(left.path) as recording:
        # The program is told no header.
        assert [line.text for line in recording.lines() if b"odom" in line.text] == [
            b'{"op":"publish","topic":"/odom","msg":{"x":1}}'
        ]
        assert not recording.is_complete
        assert recording.details == DETAILS
        assert len(list(recording.lines())) == 3


@pytest.mark.parametrize("suffix", [".log", ".mcap"])
def test_a_recording_whose_run_was_killed_is_made_when_it_is_asked_for(tmp_path: Path, suffix: str) -> None:
    left = killed(RecordingFolder(tmp_path).begin(DETAILS))
    finish_left(left.log.with_suffix(suffix))
    with open_recording(left.path) as recording:
        assert recording.details == DETAILS
    assert [path.name for path in tmp_path.iterdir()] == [left.path.name]


def test_a_named_one_as_well(tmp_path: Path) -> None:
    left = killed(named_recording(tmp_path / "my.mcap", DETAILS))
    finish_left(left.path)
    with open_recording(left.path) as recording:
        assert recording.details == DETAILS


def test_a_file_in_which_another_run_is_recorded_is_refused(tmp_path: Path) -> None:
    running = named_recording(tmp_path / "my.mcap", DETAILS)
    running.log.write_bytes(LOG)
    with pytest.raises(BadInput, match=r"my\.mcap is being recorded by another Rosy"):
        named_recording(tmp_path / "my.mcap", DETAILS)
    assert running.log.read_bytes() == LOG


def test_the_log_of_a_run_that_goes_on_is_left_alone(tmp_path: Path) -> None:
    running = RecordingFolder(tmp_path).begin(DETAILS)
    running.log.write_bytes(LOG)
    finish_left(running.path)
    assert running.log.exists()
    assert not running.path.exists()


def test_when_rosy_starts_those_that_were_left_are_made(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    left = killed(RecordingFolder(tmp_path).begin(DETAILS))
    assert main(str(tmp_path)) == 0
    assert f"The run is recorded in {left.path}." in capsys.readouterr().err


def test_a_named_file_has_to_be_writable(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match=r"nowhere/my\.mcap cannot be written: No such file or directory\."):
        named_recording(tmp_path / "nowhere" / "my.mcap", DETAILS)
    (tmp_path / "file").touch()
    with pytest.raises(BadInput, match=r"file/recordings cannot be written: Not a directory\."):
        RecordingFolder(tmp_path / "file" / "recordings").begin(DETAILS)


@pytest.mark.parametrize("damage", [slice(0, 0), slice(0, 40), slice(0, -20), slice(8, None)])
def test_a_file_that_is_damaged_is_refused_with_a_sentence(damage: slice, tmp_path: Path) -> None:
    finished = recorded(RecordingFolder(tmp_path))
    assert finished is not None
    finished.path.write_bytes(finished.path.read_bytes()[damage])
    with pytest.raises(BadInput, match="is no recording of a run"), open_recording(finished.path) as recording:
        list(recording.lines())


def test_no_flipped_byte_ends_in_a_traceback(tmp_path: Path) -> None:
    finished = recorded(RecordingFolder(tmp_path))
    assert finished is not None
    whole = finished.path.read_bytes()
    for place in range(0, len(whole), 7):
        finished.path.write_bytes(whole[:place] + bytes([whole[place] ^ 0xFF]) + whole[place + 1 :])
        try:
            with open_recording(finished.path) as recording:
                list(recording.lines())
        except BadInput:
            continue
