"""Documents of an editor: positions in every unit, and incremental changes, against one in UTF-16 bytes."""

from __future__ import annotations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from lsprotocol import types

from rosy_sim.lsp.document import Document
from rosy_sim.wire.problem import Place

from .editor import applied

TEXTS = st.text(alphabet="ab\n é🤖\x0c\u2028", max_size=30)
FILES = st.builds("".join, st.tuples(st.sampled_from(["", "\ufeff"]), st.text(alphabet="ab\n\r é🤖", max_size=30)))
ENCODINGS = [kind.value for kind in types.PositionEncodingKind]


@pytest.mark.parametrize("encoding", ENCODINGS)
@given(text=FILES, data=st.data())
def test_an_offset_survives_the_way_through_a_position_and_a_place(
    encoding: str, text: str, data: st.DataObject
) -> None:
    document = Document("file:///a.hs", text, 1, encoding)
    # No position is between the two characters of one line end, and no program in front of its mark.
    offset = data.draw(st.integers(text.startswith("\ufeff"), len(text)))
    assume(text[offset - 1 : offset + 1] != "\r\n")
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


UNITS = st.text(alphabet="ab\n🤖\ud83e\udd16", max_size=12)
"""With halves of pairs: an editor that works in UTF-16 may send one."""


@given(text=UNITS, changes=st.lists(st.tuples(st.integers(0, 30), st.integers(0, 30), UNITS), max_size=4))
def test_changes_that_cut_pairs_give_the_units_that_the_editor_has(
    text: str, changes: list[tuple[int, int, str]]
) -> None:
    def units(written: str) -> bytes:
        return written.encode("utf-16-le", "surrogatepass")

    def position(before: bytes) -> types.Position:
        lines = before.decode("utf-16-le", "surrogatepass").split("\n")
        return types.Position(len(lines) - 1, len(units(lines[-1])) // 2)

    text = units(text).decode("utf-16-le", "surrogatepass")
    document, expected = Document("file:///a.hs", text, 1), units(text)
    for one, other, inserted in changes:
        start, end = sorted(min(2 * place, len(expected)) for place in (one, other))
        where = types.Range(position(expected[:start]), position(expected[:end]))
        document = document.changed(2, [types.TextDocumentContentChangePartial(where, inserted)])
        expected = expected[:start] + units(inserted) + expected[end:]
        assert units(document.text) == expected
    assert document.source.encode("utf-8").decode("utf-8") == document.source


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_the_program_begins_behind_a_byte_order_mark(encoding: str) -> None:
    document = Document("file:///a.hs", "\ufeffa\rb\r\nc", 1, encoding)
    assert document.source == "a\nb\r\nc"
    assert document.offset_of_place(Place(1, 2)) == 2
    assert document.offset_of_place(Place(2, 1)) == 3
    assert document.place(document.position(2)) == Place(1, 2)
    assert document.place(document.position(3)) == Place(2, 1)
