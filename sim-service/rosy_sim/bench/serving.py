"""
Service of a benchmark: the whole application with its worker, on a free port of this machine, in this process.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import uvicorn

from ..classroom.store.class_store import ClassStore
from ..config import Config
from ..garbage_collection import keep_what_is_loaded
from ..web.app import build_app
from ..web.pacing.paced_frames import paced_frames
from ..web.pacing.request_deadline import RequestDeadline
from ..web.service import Service

__all__ = ["serving"]


@asynccontextmanager
async def serving(config: Config, store: ClassStore | None = None) -> AsyncIterator[tuple[Service, int]]:
    """Serve until the end of the block; yields the service, whose worker is ready, and its port."""
    app = build_app(config, store)
    service: Service = app.state.service
    keep_what_is_loaded()
    server = uvicorn.Server(
        uvicorn.Config(
            app,
            port=0,
            log_level="critical",
            http=RequestDeadline,
            ws=paced_frames(),
            ws_max_size=config.limits.page_message,
            ws_per_message_deflate=False,
            timeout_graceful_shutdown=1,
        )
    )
    serving = asyncio.create_task(server.serve())
    while not (server.started and service.worker.state == "ready"):  # noqa: ASYNC110 (nothing to wait on)
        await asyncio.sleep(0.02)
    try:
        yield service, server.servers[0].sockets[0].getsockname()[1]
    finally:
        server.should_exit = True
        await serving
