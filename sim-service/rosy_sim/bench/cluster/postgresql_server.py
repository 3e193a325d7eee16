"""
PostgreSQL server of benchmarks and tests: Debian's, in a temporary folder, for an unprivileged user, reachable by a
socket only.
"""

from __future__ import annotations

import os
import pwd
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

__all__ = ["SERVERS", "PostgresqlServer", "postgresql_server", "restartable_server"]

SERVERS = sorted(Path("/usr/lib/postgresql").glob("*/bin"), key=lambda path: int(path.parent.name))
"""Folders of its programs, of the newest version last; empty when Debian's package is not installed."""


class PostgresqlServer:
    """A server that can be stopped and started again; its data is in a folder that is its owner's."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        # PostgreSQL refuses to run as root.
        self._user = "nobody" if os.geteuid() == 0 else None
        if self._user is not None:
            account = pwd.getpwnam(self._user)
            os.chown(folder, account.pw_uid, account.pw_gid)
        data = ["-D", str(folder / "data"), "-U", "rosy"]
        initdb = [str(SERVERS[-1] / "initdb"), *data, "-A", "trust", "-E", "UTF8", "--locale=C", "-N"]
        subprocess.run(initdb, check=True, stdout=subprocess.DEVNULL, user=self._user, cwd=folder)
        self.start()

    @property
    def url(self) -> str:
        """Of its database."""
        return f"postgresql://rosy@/postgres?host={self._folder}"

    def start(self) -> None:
        """Start it, and wait until it answers."""
        folder = self._folder
        command: list[str | Path] = [SERVERS[-1] / "postgres", "-D", folder / "data", "-k", folder]
        command += ["-c", "listen_addresses=", "-c", "fsync=off"]
        with (folder / "log").open("ab") as log:
            self._server = subprocess.Popen(command, stdout=log, stderr=log, user=self._user, cwd=folder)
        ready: list[str | Path] = [SERVERS[-1] / "pg_isready", "-q", "-h", folder, "-t", "0"]
        while self._server.poll() is None and subprocess.run(ready, check=False).returncode != 0:
            continue
        if self._server.poll() is not None:
            raise RuntimeError((folder / "log").read_text())

    def stop(self, how: signal.Signals = signal.SIGQUIT) -> None:
        """Stop it: SIGQUIT at once, as if it had crashed; SIGINT after ending all connections."""
        self._server.send_signal(how)
        self._server.wait()


@contextmanager
def restartable_server() -> Iterator[PostgresqlServer]:
    """A server in a temporary folder."""
    folder = Path(tempfile.mkdtemp(prefix="rosy-postgresql-"))
    try:
        server = PostgresqlServer(folder)
        try:
            yield server
        finally:
            server.stop()
    finally:
        shutil.rmtree(folder)


@contextmanager
def postgresql_server() -> Iterator[str]:
    """A server; gives its URL."""
    with restartable_server() as server:
        yield server.url
