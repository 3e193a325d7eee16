"""
PostgreSQL server of benchmarks and tests: Debian's, in a temporary folder, for an unprivileged user, reachable by a
socket only.
"""

from __future__ import annotations

import os
import pwd
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

__all__ = ["SERVERS", "postgresql_server"]

SERVERS = sorted(Path("/usr/lib/postgresql").glob("*/bin"), key=lambda path: int(path.parent.name))
"""Folders of its programs, of the newest version last; empty when Debian's package is not installed."""


@contextmanager
def postgresql_server() -> Iterator[str]:
    """A server; gives its URL."""
    folder = Path(tempfile.mkdtemp(prefix="rosy-postgresql-"))
    # PostgreSQL refuses to run as root.
    user = "nobody" if os.geteuid() == 0 else None
    if user is not None:
        account = pwd.getpwnam(user)
        os.chown(folder, account.pw_uid, account.pw_gid)
    data = folder / "data"
    initdb: list[str | Path] = [
        SERVERS[-1] / "initdb",
        "-D",
        data,
        "-U",
        "rosy",
        "-A",
        "trust",
        "-E",
        "UTF8",
        "--locale=C",
        "-N",
    ]
    subprocess.run(initdb, check=True, stdout=subprocess.DEVNULL, user=user, cwd=folder)
    command: list[str | Path] = [
        SERVERS[-1] / "postgres",
        "-D",
        data,
        "-k",
        folder,
        "-c",
        "listen_addresses=",
        "-c",
        "fsync=off",
    ]
    log = (folder / "log").open("wb")
    server = subprocess.Popen(command, stdout=log, stderr=log, user=user, cwd=folder)
    ready: list[str | Path] = [SERVERS[-1] / "pg_isready", "-q", "-h", folder, "-t", "0"]
    try:
        while server.poll() is None and subprocess.run(ready, check=False).returncode != 0:
            continue
        assert server.poll() is None, (folder / "log").read_text()
        yield f"postgresql://rosy@/postgres?host={folder}"
    finally:
        # Immediately: nobody needs the data.
        server.send_signal(3)
        server.wait()
        log.close()
        shutil.rmtree(folder)
