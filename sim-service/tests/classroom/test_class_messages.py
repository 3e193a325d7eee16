"""Golden messages of a class: the service's types allow each of them, and the page's tests read each."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import msgspec
import pytest

from rosy_sim.classroom.messages.board_messages import BoardAnswer
from rosy_sim.classroom.messages.pupil_messages import PupilAnswer

GOLDENS = Path(__file__).resolve().parents[3] / "protocol/goldens/class"


@pytest.mark.parametrize(("name", "answers"), [("board", BoardAnswer), ("pupil", PupilAnswer)])
def test_every_golden_message_is_one_of_the_services(name: str, answers: Any) -> None:
    found = [msgspec.json.decode(line)["line"] for line in (GOLDENS / f"{name}.jsonl").read_bytes().splitlines()]
    for message in found:
        msgspec.convert(message, answers)
    # All kinds of messages but those with a part that is any JSON to the type.
    kinds = {kind.__struct_config__.tag for kind in answers.__args__}
    assert kinds - {message["op"] for message in found} <= {"room", "result"}
