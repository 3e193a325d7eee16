"""Documents of an editor: positions in every unit, and incremental changes, against one in UTF-16 bytes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lsprotocol import types

from rosy_sim.lsp.document import Document
from rosy_sim.wire.problem import Place

from .editor import applied

TEXTS = st.text(alphabet="ab\n é🤖\x0c\u2028", max_size=30)
ENCODINGS = [kind.value for kind in types.PositionEncodingKind]


@pytest.mark.parametrize("encoding", ENCODINGS)
@given(text=TEXTS, data=st.data())
def test_an_offset_survives_the_way_through_a_position_and_a_place(
    encoding: str, text: str, data: st.DataObject
) -> None:
    document = Document("file:///a.hs", text, 1, encoding)
    offset = data.draw(st.integers(0, len(text)))
    position = document.position(offset)
    assert document.offset(position) == offset
    assert document.offset_of_place(document.place(position)) == offset


@pytest.mark.parametrize(
    ("encoding", "character"), [("utf-8", 5), ("utf-16", 3), ("utf-32", 2)], ids=["utf-8", "utf-16", "utf-32"]
)
def test_a_column_after_an_emoji_counts_the_units_of_the_editor(encoding: str, character: int) -> None:
    document = Document("file:///a.hs", "x\na🤖b\n", 1, encoding)
    assert document.position(4) == types.Position(1, character)
    assert document.place(types.Position(1, character)) == Place(2, 3)


@given(text=TEXTS, inserted=TEXTS, data=st.data())
def test_an_incremental_change_gives_the_text_that_the_editor_has(
    text: str, inserted: str, data: st.DataObject
) -> None:
    document = Document("file:///a.hs", text, 1)
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, len(text)))
    where = types.Range(document.position(start), document.position(end))
    changed = document.changed(2, [types.TextDocumentContentChangePartial(where, inserted)])
    assert changed.text == applied(text, [types.TextEdit(where, inserted)])
    assert changed.version == 2


def test_changes_of_one_notification_apply_one_after_the_other() -> None:
    first = types.TextDocumentContentChangePartial(types.Range(types.Position(0, 0), types.Position(0, 0)), "🤖\n")
    second = types.TextDocumentContentChangePartial(types.Range(types.Position(1, 0), types.Position(1, 1)), "b")
    assert Document("file:///a.hs", "a", 1).changed(2, [first, second]).text == "🤖\nb"
    whole = types.TextDocumentContentChangeWholeDocument("new")
    assert Document("file:///a.hs", "a", 1).changed(2, [first, whole]).text == "new"


def test_places_beyond_a_line_or_the_text_are_its_end() -> None:
    document = Document("file:///a.hs", "ab\r\nc", 1)
    assert document.offset(types.Position(0, 99)) == 2
    assert document.offset(types.Position(9, 0)) == 5
    assert document.offset_of_place(Place(2, 99)) == document.offset_of_place(Place(9, 1)) == 5
    assert document.position(4) == types.Position(1, 0)
