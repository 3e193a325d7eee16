"""
Caller of one service over DDS: requests are written, and responses read, each on a topic of its own.

Which response answers which request is in a header of the message where the service is Cyclone DDS's, and otherwise in
a part of the protocol that Cyclone DDS, which Rosy uses, does not show (DDS-RPC 1.0, 7.8.2). Without the header a
response answers what has been asked until then, so only one question should be open.
"""

from __future__ import annotations

import itertools
import secrets
import threading
from typing import Any

from cyclonedds.core import DDSException

from .dds_messages import unreadable
from .transport import MOST_TAKEN, Answer

__all__ = ["DdsCaller"]


class DdsCaller:
    """
    Of a service of type ``kind``; ``made`` is the class of its requests. Responses are taken in threads of DDS.
    """

    def __init__(self, kind: str, made: Any, has_header: bool) -> None:
        self.is_exact = has_header
        self._kind = kind
        self._made = made
        # Who it is, for services with a header.
        self._client = secrets.randbits(64)
        self._numbers = itertools.count(1)
        self._lock = threading.Lock()
        self._writer: Any = None
        self._reader: Any = None
        # By the numbers of the requests.
        self._calls: dict[int, Answer] = {}

    def use(self, writer: Any, reader: Any) -> None:
        """Of the requests, and of the responses."""
        self._writer, self._reader = writer, reader

    def is_matched(self) -> bool:
        """Whether the service hears it, and is heard."""
        return bool(self._writer.get_matched_subscriptions()) and bool(self._reader.get_matched_publications())

    def call(self, request: Any, on_answer: Answer) -> None:
        """``on_answer`` is called once the service has answered."""
        with self._lock:
            number = next(self._numbers)
            self._calls[number] = on_answer
        if self.is_exact:
            request = self._made(rosy_client=self._client, rosy_number=number, **vars(request))
        try:
            self._writer.write(request)
        except DDSException:
            # The service's queue is full: the caller hears that there is no answer instead of waiting for one.
            self._answer(None, number)

    def take(self) -> None:
        """There may be responses."""
        if self._reader is None:
            return
        try:
            responses = self._reader.take(MOST_TAKEN)
        except Exception:  # noqa: BLE001 cyclonedds raises whatever its decoding meets
            self._answer(unreadable(f"{self._kind}_Response"), None)
            return
        for response in responses:
            if not response.sample_info.valid_data:
                continue
            if not self.is_exact:
                self._answer(response, None)
            elif response.rosy_client == self._client:
                self._answer(response, response.rosy_number)

    def _answer(self, response: Any, number: int | None) -> None:
        """Of the request with this number, or of all that are open."""
        with self._lock:
            numbers = [number] if number in self._calls else [] if number is not None else list(self._calls)
            answered = [self._calls.pop(number) for number in numbers]
        for on_answer in answered:
            on_answer(response)
