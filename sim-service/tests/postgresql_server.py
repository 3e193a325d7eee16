"""PostgreSQL server of the tests, where it and its driver are installed."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from rosy_sim.bench.cluster.postgresql_server import SERVERS, PostgresqlServer, postgresql_server, restartable_server

__all__ = ["PostgresqlServer", "needs_postgresql", "postgresql_server", "restartable_server"]

_SITE = Path(__file__).resolve().parents[2] / ".rosy" / "venv-cluster" / "lib"

_REASON = (
    "postgresql: Debian's package postgresql is not installed"
    if not SERVERS
    else "postgresql: psycopg is not installed; ./rosy start --cluster installs it"
)

needs_postgresql = pytest.mark.skipif(not SERVERS or not list(_SITE.glob("*/site-packages/psycopg")), reason=_REASON)

# Last: everything else comes from the environment of the tests.
sys.path += [str(path) for path in _SITE.glob("*/site-packages")]
