"""
Registry of the services that rosbridge clients offer, and of the calls that they have not answered yet
(rosbridge v2.0 Protocol Specification, sections 3.3.6 to 3.3.9).

Pure. In: offers, calls, answers and clients that leave. Out: who answers, and whose calls have failed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generic, TypeVar

__all__ = ["Call", "ClientServices"]

_RESERVED = "/rosapi/"

Client = TypeVar("Client")


@dataclass(slots=True)
class Call(Generic[Client]):
    """A call of a client."""

    caller: Client
    # The service and the identifier as the caller wrote them.
    service: str
    ident: Any
    # Longest frame of the answer, characters.
    fragment: int | None


class ClientServices(Generic[Client]):
    """Of one session. Names are absolute."""

    def __init__(self, types: dict[str, str], limit: int) -> None:
        # Of the offered services; shared with rosapi.
        self._types = types
        # Services of the session, and calls of one client that are not answered yet.
        self._limit = limit
        self._providers: dict[str, Client] = {}
        # Name and call by the identifier that the offering client sees.
        self._calls: dict[str, tuple[str, Call[Client]]] = {}
        self._cancelled: list[Call[Client]] = []
        self._count = 0

    def provider(self, name: str) -> Client | None:
        """Who answers calls of a service."""
        return self._providers.get(name)

    def offer(self, name: str, kind: str, client: Client) -> bool:
        """Let a client answer calls of a service, in place of the one before; whether that is possible."""
        if name.startswith(_RESERVED) or (name not in self._providers and len(self._providers) >= self._limit):
            return False
        self.withdraw(name)
        self._providers[name] = client
        self._types[name] = kind
        return True

    def withdraw(self, name: str) -> None:
        """End a service; its calls are cancelled."""
        self._providers.pop(name, None)
        self._types.pop(name, None)
        for ident in [ident for ident, (called, _) in self._calls.items() if called == name]:
            self._cancelled.append(self._calls.pop(ident)[1])

    def leave(self, client: Client) -> None:
        """A client has disconnected: its services end, and its calls are forgotten."""
        for name in [name for name, provider in self._providers.items() if provider is client]:
            self.withdraw(name)
        self._calls = {ident: entry for ident, entry in self._calls.items() if entry[1].caller is not client}
        self._cancelled = [call for call in self._cancelled if call.caller is not client]

    def called(self, name: str, call: Call[Client]) -> str | None:
        """Keep a call until it is answered; its identifier, or nothing when the caller has too many."""
        if sum(other.caller is call.caller for _, other in self._calls.values()) >= self._limit:
            return None
        self._count += 1
        ident = f"service_request:{name}:{self._count}"
        self._calls[ident] = (name, call)
        return ident

    def answered(self, ident: str, client: Client) -> Call[Client] | None:
        """The call that a client answers, if it is for this client."""
        entry = self._calls.get(ident)
        if entry is None or self._providers.get(entry[0]) is not client:
            return None
        del self._calls[ident]
        return entry[1]

    def cancelled(self) -> list[Call[Client]]:
        """The calls that were cancelled since the last time."""
        calls, self._cancelled = self._cancelled, []
        return calls
