"""
Process of a bridge: ``python -m rosy_sim.ros2.bridge_process DOMAIN ADDRESS PORT``; the address may be empty, and a
port of 0 is any.

Out, on standard output: ``port N`` when clients may come, then ``topics JSON``, an array of an object of topics and
types and one of topics and the computers that publish them, now and whenever that changes. It ends when its standard
input does, so also when what has started it is killed.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import signal
import sys

from websockets.asyncio.server import serve

from .bridge import Bridge
from .guardian_process import GuardianProcess
from .transports.open_transport import open_transport

__all__: list[str] = []


def _say(*words: object) -> None:
    # What has started it may be gone.
    with contextlib.suppress(OSError):
        print(*words, flush=True)


async def _main(domain: int, address: str | None, port: int) -> None:
    transport = open_transport(domain, address)
    bridge = Bridge(transport, GuardianProcess(domain, address))
    ended = asyncio.Event()
    loop = asyncio.get_running_loop()
    loop.add_reader(sys.stdin, ended.set)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        loop.add_signal_handler(number, ended.set)
    # A page of another site must not drive the robot: browsers send the site's name as Origin, programs send none.
    async with serve(bridge.serve, "127.0.0.1", port, origins=[None], ping_interval=None, compression=None) as server:
        _say("port", server.sockets[0].getsockname()[1])
        running = asyncio.create_task(bridge.run(lambda *topics: _say("topics", json.dumps(topics))))
        await ended.wait()
        bridge.stop()
        running.cancel()
    transport.close()


if __name__ == "__main__":
    asyncio.run(_main(int(sys.argv[1]), sys.argv[2] or None, int(sys.argv[3])))
