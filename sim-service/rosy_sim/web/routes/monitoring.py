"""Routes that tell how busy the service is: as JSON, and in the text format of Prometheus."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Route

from ...version import VERSION
from ..service import Service

__all__ = ["Monitoring"]


class Monitoring:
    """Of a service."""

    def __init__(self, service: Service) -> None:
        self._service = service

    def routes(self) -> list[BaseRoute]:
        """Below ``/api``."""
        return [Route("/api/health", self._health), Route("/api/metrics", self._metrics)]

    async def _health(self, _request: Request) -> Response:
        """Version, state of the worker, number of pages and of runs, lateness of their steps."""
        service, runs = self._service, self._service.budgets.runs
        return JSONResponse(
            {
                "version": VERSION,
                "worker": service.worker.state,
                "sessions": len(service.sessions),
                "runs": {"now": runs.running, "limit": runs.policy.places, "queued": runs.queued},
                "lateness": service.lateness.summary(),
            }
        )

    async def _metrics(self, _request: Request) -> Response:
        service, runs = self._service, self._service.budgets.runs
        values = {
            "rosy_pages": len(service.sessions),
            "rosy_runs": runs.running,
            "rosy_runs_limit": runs.policy.places,
            "rosy_runs_queued": runs.queued,
            "rosy_worker_ready": int(service.worker.state == "ready"),
            "rosy_store_ready": None if service.classroom is None else int(service.classroom.store_fault() is None),
            **{f"rosy_step_lateness_{name}": value for name, value in service.lateness.summary().items()},
        }
        lines = [f"# TYPE {name} gauge\n{name} {value}\n" for name, value in values.items() if value is not None]
        return PlainTextResponse("".join(lines), media_type="text/plain; version=0.0.4")
