"""
Shared editing of a running class: the teacher asks a pupil, and when the pupil allows it both edit the same text.

The service decides the order of the changes: those that follow the newest version become the next one and are sent to
both sides; others are dropped, because the side that sent them gets the newer version first, rebases them and sends
them again. The text itself stays with the two pages. Nothing is stored; the pupil's page saves its program as always.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Any

from .messages.message_fields import Refused
from .messages.shared_messages import (
    Asked,
    AskToShare,
    Cursor,
    Decline,
    EndSharing,
    Over,
    Push,
    Share,
    Shared,
    Side,
    Update,
    Updates,
    Waiting,
    length_after,
    utf16_length,
)

__all__ = ["Participant", "SharedEditing"]


@dataclass(frozen=True, slots=True)
class Participant:
    """A board or a pupil's page: its connection, and how to send to it, which never blocks."""

    connection: Hashable
    put: Callable[[Any], None] = field(compare=False)


@dataclass(slots=True)
class _Session:
    """A question and, when ``page`` is set, the editing that it led to."""

    number: int
    pupil: int
    question: Asked
    board: Participant
    page: Participant | None = None
    version: int = 0
    # Of the text of this version, in UTF-16 units.
    length: int = 0


class SharedEditing:
    """
    All questions and shared programs.

    Args:
        pages: the connected pages of a pupil.
    """

    def __init__(self, pages: Callable[[int], list[Participant]]) -> None:
        self._pages = pages
        self._numbers = itertools.count(1)
        # By pupil; a board has at most one.
        self._sessions: dict[int, _Session] = {}

    # The board

    def ask(self, board: Participant, request: AskToShare, name: str) -> Refused | None:
        """Ask a pupil about a program that the pupil has; what is returned says why not."""
        own = self._of_board(board.connection)
        if own is not None:
            self._end(own)
        if request.pupil in self._sessions:
            return Refused("busy")
        pages = self._pages(request.pupil)
        if not pages:
            return Refused("away")
        question = Asked(next(self._numbers), request.program, name)
        self._sessions[request.pupil] = _Session(question.number, request.pupil, question, board)
        for page in pages:
            page.put(question)
        board.put(Waiting(request.pupil, request.program))
        return None

    def serve_board(self, board: Participant, request: Push | Cursor | EndSharing) -> Refused | None:
        """A request of the side that asked."""
        return self._serve(self._of_board(board.connection), "teacher", request)

    def board_left(self, connection: Hashable) -> None:
        """A board has disconnected."""
        if (session := self._of_board(connection)) is not None:
            self._end(session)

    # Pupils

    def page_entered(self, pupil: int, page: Participant) -> None:
        """A pupil's page has connected: it shows the question that waits for an answer."""
        session = self._sessions.get(pupil)
        if session is not None and session.page is None:
            page.put(session.question)

    def serve_page(
        self, pupil: int, page: Participant, request: Share | Decline | Push | Cursor | EndSharing
    ) -> Refused | None:
        """A request of a pupil's page."""
        session = self._sessions.get(pupil)
        match request:
            case Share() | Decline():
                if session is None or session.page is not None or session.number != request.number:
                    # It was answered or withdrawn a moment ago.
                    page.put(Over("ended"))
                elif isinstance(request, Share):
                    self._begin(session, page, request)
                else:
                    self._end(session, "declined")
                return None
            case _:
                is_shared = session is not None and session.page == page
                return self._serve(session if is_shared else None, "pupil", request)

    def page_left(self, pupil: int, connection: Hashable) -> None:
        """A pupil's page has disconnected."""
        session = self._sessions.get(pupil)
        if session is not None and session.page is not None and session.page.connection == connection:
            self._end(session)

    def pupil_left(self, pupil: int) -> None:
        """A pupil is not in the class any more."""
        if (session := self._sessions.get(pupil)) is not None:
            self._end(session)

    def page_unreadable(self, pupil: int, connection: Hashable) -> None:
        """A pupil's page sent an answer or changes that cannot be read: it would wait for the service for ever."""
        session = self._sessions.get(pupil)
        if session is not None and (session.page is None or session.page.connection == connection):
            self._end(session)

    # Both

    def _of_board(self, connection: Hashable) -> _Session | None:
        return next((one for one in self._sessions.values() if one.board.connection == connection), None)

    def _begin(self, session: _Session, page: Participant, request: Share) -> None:
        session.page, session.length = page, utf16_length(request.text)
        for other in self._pages(session.pupil):
            if other != page:
                other.put(Over("ended"))
        page.put(Shared())
        session.board.put(Shared(request.project, request.text))

    def _serve(self, session: _Session | None, side: Side, request: Push | Cursor | EndSharing) -> Refused | None:
        if isinstance(request, EndSharing):
            if session is not None:
                self._end(session)
            return None
        # The last changes and positions may arrive after the other side has ended it.
        if session is None or session.page is None:
            return Refused("request")
        if isinstance(request, Push):
            return self._push(session, session.page, side, request)
        other = session.board if side == "pupil" else session.page
        other.put(Cursor(request.version, request.anchor, request.head))
        return None

    def _push(self, session: _Session, page: Participant, side: Side, request: Push) -> Refused | None:
        if request.version != session.version:
            return None
        length: int | None = session.length
        for changes in request.changes:
            length = None if length is None else length_after(changes, length)
        if length is None:
            # This side has another text than the other one.
            self._end(session)
            return Refused("request")
        updates = Updates(session.version, [Update(side, changes) for changes in request.changes])
        session.version += len(request.changes)
        session.length = length
        for one in (page, session.board):
            one.put(updates)
        return None

    def _end(self, session: _Session, why: str = "ended") -> None:
        del self._sessions[session.pupil]
        session.board.put(Over("declined" if why == "declined" else "ended"))
        pages = self._pages(session.pupil) if session.page is None else [session.page]
        for page in pages:
            page.put(Over("ended"))
