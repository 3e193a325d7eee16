"""
A worker that compiles nothing: a source is a script of ``fake_program``, played in a forked child. Forks workers, too.

Words of its own: ``refuse`` (does not compile), ``slow`` (never finishes compiling), ``die`` (the worker itself
dies), ``hang`` (it runs in circles), ``babble`` (sends what is no answer). Run it as a program with its socket as
descriptor 3. It has one thread, as the real one: one that waits for another thread looks as if it did nothing.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import selectors
import signal
import socket
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from tests.fake_program import Script, play

PROBLEM = {
    "severity": "error", "kind": "type-mismatch", "message": "`move` gives a number.",
    "hint": "The robot needs a Velocity.", "ghc": "",
    "start": {"line": 1, "column": 1}, "end": {"line": 1, "column": 5},
}  # fmt: skip


PR_SET_PDEATHSIG = 1
"""prctl(2)."""


class Worker:
    def __init__(self, descriptor: int = 3) -> None:
        self.socket = socket.socket(fileno=descriptor)
        self.children: dict[int, int] = {}
        # Prepared runs: the robot link by id.
        self.prepared: dict[int, int] = {}
        self.compiling: set[int] = set()
        # The socket, and a descriptor of each child with its id.
        self.selector = selectors.DefaultSelector()
        # What has been received and is not a whole request yet.
        self.rest = b""
        self.descriptors: list[int] = []

    def send(self, **message: Any) -> None:
        self.socket.sendall(json.dumps(message).encode() + b"\n")

    def run(self) -> None:
        """Serve until the other end is closed; leave no program. One that has not read all resets the connection."""
        try:
            with contextlib.suppress(ConnectionError):
                self.serve()
        finally:
            for pid in self.children.values():
                os.kill(pid, signal.SIGKILL)

    def serve(self) -> None:
        self.send(op="ready", protocol=1, ghc="9.0.2")
        self.selector.register(self.socket, selectors.EVENT_READ)
        while True:
            for ready, _ in self.selector.select():
                if ready.data is not None:
                    self.reap(ready.data, ready.fd)
                elif not self.receive():
                    return

    def receive(self) -> bool:
        """Take requests; returns whether there may be more."""
        data, arrived, _, _ = socket.recv_fds(self.socket, 1 << 16, 8)
        self.descriptors += arrived[:1]
        # The memory of a mailbox, which these programs do not use.
        for other in arrived[1:]:
            os.close(other)
        *lines, self.rest = (self.rest + data).split(b"\n")
        for line in lines:
            self.take(json.loads(line), self.descriptors)
        return bool(data)

    def take(self, request: dict[str, Any], descriptors: list[int]) -> None:
        ident = request["id"]
        match request["op"]:
            case "check":
                script = Script(request["source"])
                if script.has("die"):
                    os._exit(1)
                while script.has("hang"):
                    pass
                if script.has("babble"):
                    self.socket.sendall(b"what?\n")
                if script.has("slow"):
                    return
                self.send(
                    op="checked", id=ident, problems=[PROBLEM] if script.has("refuse") else [],
                    declarations=[], graph={"functions": []}, types={"names": ["IO ()"], "at": [[1, 1, 1, 5, 0]]},
                )  # fmt: skip
            case "complete":
                if not Script(request["source"]).has("slow"):
                    name = {"name": f"at{request['line']}_{request['column']}", "type": "Velocity", "takes": 0}
                    self.send(op="completed", id=ident, expected="Velocity", names=[name])
            case "run":
                link = self.prepared.pop(ident, None)
                self.start(ident, request["source"], descriptors.pop(0) if link is None else link)
            case "prepare":
                self.prepared[ident] = descriptors.pop(0)
            case "fork":
                self.fork(ident, descriptors.pop(0))
            case "ping":
                self.send(op="pong", id=ident)
            case "kill" if ident in self.prepared:
                os.close(self.prepared.pop(ident))
                self.send(op="gone", id=ident, signal=signal.SIGKILL)
            case "kill" if ident in self.compiling:
                self.compiling.discard(ident)
                self.send(op="gone", id=ident, signal=signal.SIGKILL)
            case "kill":
                with contextlib.suppress(KeyError, ProcessLookupError):
                    os.kill(self.children[ident], signal.SIGKILL)

    def fork(self, ident: int, descriptor: int) -> None:
        """Another worker, which serves this socket."""
        pid = os.fork()
        if pid == 0:
            try:
                ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
                self.socket.close()
                self.selector.close()
                Worker(descriptor).run()
            finally:
                os._exit(0)
        os.close(descriptor)
        self.watch(ident, pid)
        self.send(op="forked", id=ident, pid=pid)

    def watch(self, ident: int, pid: int) -> None:
        """A child, until it ends."""
        self.children[ident] = pid
        self.selector.register(os.pidfd_open(pid), selectors.EVENT_READ, ident)

    def start(self, ident: int, source: str, descriptor: int) -> None:
        script = Script(source)
        if script.has("die"):
            os._exit(1)
        if script.has("refuse") or script.has("slow"):
            os.close(descriptor)
            if script.has("slow"):
                self.compiling.add(ident)
            if script.has("refuse"):
                self.send(op="refused", id=ident, problems=[PROBLEM])
            return
        self.send(op="started", id=ident, problems=[], compile=0.001, uses=["Bumper"] if script.has("bump") else [])
        pid = os.fork()
        if pid == 0:
            try:
                self.socket.close()
                # proc(5): tests tell it from the worker's other processes.
                Path("/proc/self/comm").write_text("program")
                play(socket.socket(fileno=descriptor), source)
            finally:
                os._exit(0)
        os.close(descriptor)
        self.watch(ident, pid)

    def reap(self, ident: int, descriptor: int) -> None:
        """Say how a child has ended."""
        self.selector.unregister(descriptor)
        os.close(descriptor)
        _, status = os.waitpid(self.children.pop(ident), 0)
        if os.WIFSIGNALED(status):
            self.send(op="gone", id=ident, signal=os.WTERMSIG(status), firing="move")
        else:
            self.send(op="gone", id=ident, exit=os.WEXITSTATUS(status))


if __name__ == "__main__":
    Worker().run()
