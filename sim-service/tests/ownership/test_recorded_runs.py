"""A page looks at the recording of a run on a real robot: by the number of the run, and as a file that it sends."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest
from mcap.writer import Writer

from rosy_sim.config import Config, discover
from rosy_sim.recordings import recorded_run
from rosy_sim.web.routes import recordings

from ..conftest import PATIENCE
from ..web.page_client import opened
from .robot_rig import Rig
from .test_robot_ownership import story

pytestmark = pytest.mark.skipif(discover().robot_executable is None, reason="rosy-robot is not built")

SCRIPT = "drive:0.2 tell count bump led:2@3 say:hi@4"

REAL, SHOWN = 1, 2


async def recorded(rig: Rig, script: str = SCRIPT, run: int = REAL) -> Path:
    """A run on the robot, which backs off from what it touches until it is stopped; its recording."""
    await rig.drives(script, run)
    rig.robot.bumped()
    touched = await rig.page.until(
        lambda m: m["op"] == "frame" and m["run"] == run and m["channels"].get("Bumper") == [1, 0, 0]
    )
    await rig.page.until(lambda m: m["op"] == "frame" and m["time"] > touched["time"] + 0.6)
    await rig.page.send("stop")
    await rig.page.op("state", run=run, state="ended")
    return Path((await rig.page.op("recorded", run=run))["file"])


async def sent(rig: Rig, name: str, data: bytes, session: str | None = None, **headers: str) -> httpx.Response:
    """A page sends a file."""
    session = session or next(iter(rig.service.sessions))
    async with httpx.AsyncClient(base_url=f"http://{rig.address}", timeout=PATIENCE) as asking:
        return await asking.post(f"/api/recordings/{session}", params={"name": name}, content=data, headers=headers)


async def shown(rig: Rig, **request: Any) -> list[dict[str, Any]]:
    """The frames of a recording that is shown to its end."""
    await rig.page.send("replay", run=SHOWN, **request)
    before = len(rig.page.seen)
    await rig.page.op("state", run=SHOWN, state="ended")
    return [m for m in rig.page.seen[before:] if m["op"] == "frame" and m["run"] == SHOWN]


def poses(frames: list[dict[str, Any]]) -> dict[float, tuple[float, float]]:
    """By their times."""
    return {frame["time"]: (frame["pose"]["x"], frame["pose"]["y"]) for frame in frames}


def test_a_page_looks_at_its_run_again_and_asks_why(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        path = await recorded(rig)
        assert path.parent == tmp_path / "recordings"
        frames = await shown(rig, of=REAL)
        assert next(m for m in rig.page.seen if m["op"] == "replayed") == {
            "op": "replayed", "run": SHOWN, "program": SCRIPT, "robot": "Kitchen",
        }  # fmt: skip
        assert next(m for m in reversed(rig.page.seen) if m["op"] == "state")["ended"] == "stopped"
        # A frame of each step and one of the end: none is left out, as those of a robot that drives are.
        assert [frame["step"] for frame in frames[:-1]] == list(range(len(frames) - 1))
        assert len(frames) > 10
        # From where it started, on open floor.
        assert frames[0]["pose"]["x"] == pytest.approx(0, abs=0.05)
        # Its safety rules back off from what it touches.
        furthest = max(frame["pose"]["x"] for frame in frames)
        assert frames[-1]["pose"]["x"] < furthest - 0.02
        # A frame holds only the channels that have changed.
        last = {name: value for frame in frames for name, value in frame["channels"].items()}
        assert (last["Bumper"], last["Led1"]) == ([1, 0, 0], [2])
        assert {"Velocity", "TurnRate", "ExternalPower"} <= last.keys()
        assert [m["text"] for m in rig.page.seen if m["op"] == "said" and m["run"] == SHOWN] == ["hi"]
        assert any("memory" in frame for frame in frames)
        await rig.page.send("why", id=1, run=SHOWN, time=frames[-5]["time"])
        found = await rig.page.op("because", id=1)
        assert [one["said"]["id"] for one in found["sentences"]] == ["sent", "overridden", "ran-tick"]
        assert found["path"][-1]["function"] == "f"
        assert not [m for m in rig.page.seen if m["op"] == "refusal"]

    story(tell, config, tmp_path)


def test_a_file_is_shown_in_the_room_of_the_page(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        data = (await recorded(rig)).read_bytes()
        async with opened(rig.address) as other:
            session = next(reversed(rig.service.sessions))
            assert (await sent(rig, "seen.mcap", data, session)).json() == {}
            await other.send("replay", run=5, room=True)
            begun = await other.op("replayed", run=5)
            assert (begun["program"], begun["robot"]) == (SCRIPT, "Kitchen")
            frame = await other.until(lambda m: m["op"] == "frame" and m["run"] == 5)
            assert (frame["pose"]["x"], frame["pose"]["y"]) == pytest.approx((1.5, 2.0), abs=0.05)
            await other.op("state", run=5, state="ended", ended="stopped")
            # The same file once more.
            await other.send("replay", run=6)
            await other.op("state", run=6, state="ended", ended="stopped")

    story(tell, config, tmp_path)


def test_a_program_that_sends_other_commands_is_shown_up_to_there(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        data = (await recorded(rig)).read_bytes()
        # What the program said is replaced: another program, which does not say so.
        await sent(rig, "other.mcap", data.replace(b"say:hi@4", b"say:ho@4"))
        frames = await shown(rig)
        said = [m["message"] for m in rig.page.seen if m["op"] == "refusal"]
        assert len(said) == 1
        assert "no longer sends the recorded commands" in said[0]
        assert 1 <= len(frames) < 10

    story(tell, config, tmp_path)


def foreign(path: Path) -> bytes:
    """An MCAP file of something else."""
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start()
        writer.finish()  # type: ignore[no-untyped-call]
    return path.read_bytes()


def test_each_file_that_is_no_recording_gets_one_sentence(config: Config, tmp_path: Path) -> None:
    async def tell(rig: Rig) -> None:
        await rig.takes()
        data = (await recorded(rig)).read_bytes()
        damaged = "x.mcap is no recording of a run, or is damaged. Choose an .mcap file that Rosy has stored."
        refusals = {
            b"no such thing": damaged,
            b"": damaged,
            data[: len(data) // 2]: damaged,
            foreign(tmp_path / "foreign"): "x.mcap is no recording of a run: it lacks the program that was recorded.",
        }
        for number, (content, said) in enumerate(refusals.items(), 10):
            await sent(rig, "x.mcap", content)
            await rig.page.send("replay", run=number)
            assert (await rig.page.op("refusal"))["message"] == said
            await rig.page.op("state", run=number, state="ended", ended="stopped")
        await rig.page.send("replay", run=20, of=7)
        assert "not known any more" in (await rig.page.op("refusal"))["message"]
        # The page goes on.
        assert await shown(rig, of=REAL)

    story(tell, config, tmp_path)


def test_files_are_taken_from_the_page_itself_and_up_to_a_size(
    config: Config, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recordings, "MOST_BYTES", 1000)

    async def tell(rig: Rig) -> None:
        await rig.page.send("replay", run=1)
        assert "has not arrived" in (await rig.page.op("refusal"))["message"]
        long = await sent(rig, "long.mcap", b"x" * 1001)
        assert (long.status_code, long.json()["message"]) == (413, "long.mcap is too large for a recording of a run.")
        assert (await sent(rig, "x", b"x", "guessed")).status_code == 404
        assert (await sent(rig, "x", b"x", origin="http://elsewhere.example")).status_code == 404
        assert (await sent(rig, "x", b"x", origin=f"http://{rig.address}")).status_code == 200

    story(tell, config, tmp_path)


def test_a_long_recording_has_fewer_frames_and_stop_ends_it(
    config: Config, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorded_run, "MOST_FRAMES", 3)

    async def tell(rig: Rig) -> None:
        await rig.takes()
        await recorded(rig)
        frames = await shown(rig, of=REAL)
        assert len(frames) <= 5
        # What fired between frames is told with the next one: a function in every fifth step of 0.6 s and more.
        assert sum(len(frame["fired"]) for frame in frames) >= 6
        await rig.page.send("replay", run=3, of=REAL)
        await rig.page.op("replayed", run=3)
        await rig.page.send("pause")
        await rig.page.op("state", run=3, state="running")
        await rig.page.send("stop")
        assert (await rig.page.op("state", run=3, state="ended"))["ended"] == "stopped"
        # Another run takes the place of one that is being shown.
        await rig.page.send("replay", run=4, of=REAL)
        await rig.page.send("replay", run=5, of=REAL)
        await rig.page.op("state", run=5, state="ended", ended="stopped")

    story(tell, config, tmp_path)
