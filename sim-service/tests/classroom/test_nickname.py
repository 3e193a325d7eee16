"""Nicknames: what is accepted and what is not."""

from __future__ import annotations

import pytest

from rosy_sim.classroom.messages.nickname import BadNickname, read_nickname


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("Ada", "Ada"),
        ("  Ada   L. ", "Ada L."),
        ("Zoë", "Zoë"),
        ("Zoe\u0308", "Zoë"),
        ("小明", "小明"),
        ("محمد", "محمد"),
        ("Nguyễn", "Nguyễn"),
        ("<b>Ada</b>", "<b>Ada</b>"),
        ("Robot 7 🤖", "Robot 7 🤖"),
        ("Ada\u00a0L", "Ada L"),
    ],
)
def test_a_name_is_accepted(typed: str, name: str) -> None:
    assert read_nickname(typed) == name


@pytest.mark.parametrize(
    ("typed", "fault"),
    [
        ("", "nickname-empty"),
        ("   ", "nickname-empty"),
        ("!!!", "nickname-empty"),
        ("a" * 25, "nickname-long"),
        ("a" * 100_000, "nickname-long"),
        # One character that Unicode's compatibility form makes 18 of.
        ("\ufdfa\ufdfa", "nickname-long"),
        ("Ada\x07", "nickname-letters"),
        ("A\nda", "nickname-letters"),
        ("\u202eadA", "nickname-letters"),
        ("Ada\u200b", "nickname-letters"),
        ("Ada\u2028Ben", "nickname-letters"),
        ("\ue000Ada", "nickname-letters"),
        ("\ud800Ada", "nickname-letters"),
        ("Z" + "\u0335" * 9, "nickname-letters"),
    ],
)
def test_a_name_is_refused(typed: str, fault: str) -> None:
    found = read_nickname(typed)
    assert isinstance(found, BadNickname)
    assert found.fault == fault
