"""Messages of a page about recorded runs."""

from __future__ import annotations

import msgspec

__all__ = ["Replay", "ReplayBegun", "RunRecorded"]


class Replay(msgspec.Struct, tag="replay", tag_field="op"):
    """
    Look at a recorded run, as run number ``run``: of this page's run ``of`` on a real robot, or, without one, from the
    file that the page sent last. ``room``: the page draws its room, and the run from its start on.
    """

    run: int
    of: int | None = None
    room: bool = False


class RunRecorded(msgspec.Struct, tag="recorded", tag_field="op"):
    """A run of this page on a real robot is in this file, on the computer of the service."""

    run: int
    file: str


class ReplayBegun(msgspec.Struct, tag="replayed", tag_field="op"):
    """A recording is shown from now on as this run: its program, and what the robot was called."""

    run: int
    program: str
    robot: str
