"""
Node of a cluster: command ``./rosy start --cluster [ADDRESS]``.

Without an address this machine becomes the head of a new cluster; with one it joins that cluster. The command waits for
Ray's processes until it is interrupted, and takes everything of the node with it. What Ray says goes to a file.

A client of Ray can run anything as its user, so all nodes and commands of a cluster share a secret token in a file.
The head makes it; a person copies it to the other machines.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path

from ..config import Config
from ..errors import BadInput, RosyError, WorkerMissing
from ..sentences.sentence import tr
from ..sentences.wording import in_terminal
from ..web.lan_addresses import lan_addresses
from ..worker.launcher import missing_sandbox
from .version import version_resource

__all__ = [
    "DEFAULT_PORT",
    "PAGES",
    "SECRET_REFUSED",
    "ClusterError",
    "other_secret",
    "reach",
    "start_node",
    "use_token",
]

_POLL = 0.2
"""Between two looks whether Ray has started, s."""

DEFAULT_PORT = 6379
"""Ray's own default for the head of a cluster."""


PAGES, PAGES_PER_PROCESSOR = "pages", 60
"""Resource of a node: pages that it serves in time. 150 pages take nine tenths of a core for the service, and as much
for their programs (``bench/pages.py``)."""

_SETTINGS = {
    # A node that is dead is found in about 5 s; one that stands still has 10 s for each answer (Ray's own timeout).
    "RAY_health_check_period_ms": "1000",
    "RAY_health_check_failure_threshold": "5",
    # A node that ends waits for its tasks, a few seconds each; Ray's 30 s are for services that move away meanwhile.
    "RAY_GRACEFUL_SHUTDOWN_DRAIN_TIMEOUT_S": "5",
    # On a busy machine the head may need longer than Ray's 30 s, and so may the first process of a task, than its 60 s.
    "RAY_gcs_server_port_wait_time_s": "600",
    "RAY_worker_register_timeout_seconds": "600",
}
"""Environment of Ray's processes; ray_config_def.h of Ray has the names."""

_REACH = 30.0
"""For the head to accept a connection, s."""

SECRET_REFUSED = b"InvalidAuthToken"
"""What Ray writes, again and again, when a cluster has another secret."""

_TOO_SLOW, _ATTEMPTS = b"timed out during startup", 10
"""What Ray says when a node took more than 30 s to start, for which it has no setting, and how often it is tried."""


def token_file() -> Path:
    """The secret of the cluster: ROSY_CLUSTER_TOKEN names its file; else in the person's data folder."""
    data = os.environ.get("XDG_DATA_HOME", "")
    home = Path(data) if data.startswith("/") else Path.home() / ".local" / "share"
    return Path(os.environ.get("ROSY_CLUSTER_TOKEN") or home / "rosy" / "cluster-token")


def use_token() -> None:
    """
    Have Ray, when it is imported in this process, ask for the token and show it.

    Raises:
        BadInput: there is none on this machine.
    """
    file = token_file()
    if not file.is_file():
        raise BadInput(
            tr(
                "The secret of the cluster is not on this machine. Copy {file} from the machine where the cluster was "
                "started to the same place here.",
                file=str(file),
            )
        )
    os.environ |= {"RAY_AUTH_MODE": "token", "RAY_AUTH_TOKEN_PATH": str(file), "RAY_USAGE_STATS_ENABLED": "0"}


class ClusterError(RosyError):
    """The cluster cannot be used from this machine, or not any more."""


def reach(address: str) -> None:
    """
    See that something listens at HOST:PORT; Ray would try for minutes.

    Raises:
        ClusterError: nothing does.
    """
    host, _, port = address.rpartition(":")
    try:
        if not host or not port.isdecimal():
            raise ValueError("HOST:PORT")
        with socket.create_connection((host, int(port)), _REACH):
            pass
    except (OSError, OverflowError, UnicodeError, ValueError) as error:
        why = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise ClusterError(
            tr(
                "No cluster answers at {address} ({why}). It is begun on its first machine by ./rosy start --cluster, "
                "which prints the address.",
                address=address,
                why=why,
            )
        ) from error


def other_secret(address: str) -> ClusterError:
    """The cluster has another secret than this machine."""
    return ClusterError(
        tr(
            "The cluster at {address} has another secret. Copy {file} from the machine where the cluster was started "
            "to the same place here.",
            address=address,
            file=str(token_file()),
        )
    )


def start_node(config: Config, options: argparse.Namespace, output: Callable[[str], None]) -> int:
    """
    Be a node until an interrupt; returns the exit status.

    Raises:
        BadInput: an option cannot be used, or the token is missing.
        WorkerMissing: this machine cannot run programs.
        ClusterError: no cluster answers at the address, or it has another secret.
        ClusterFailed: Ray could not start, or ended by itself.
    """
    if not config.worker:
        raise WorkerMissing
    port = DEFAULT_PORT if options.port is None else options.port
    if not 1 <= port <= 65535:
        raise BadInput(tr("--port must be between 1 and 65535."))
    processes = options.processes if options.processes is not None else len(os.sched_getaffinity(0))
    if not 1 <= processes <= 256:
        raise BadInput(tr("--processes must be between 1 and 256."))
    # Not by Ray's script, which names an interpreter by the path where it was installed.
    command = [sys.executable, "-m", "ray.scripts.scripts", "start", "--block", "--disable-usage-stats"]
    # No client is shown what tasks print (`connection.py`), so nothing is to read it.
    command += ["--num-cpus", str(processes), "--include-log-monitor", "false"]
    host = options.host or next(iter(lan_addresses()), "127.0.0.1")
    address = options.address or f"{host}:{port}"
    if options.address is None:
        _make_token()
        # Machines join by the command, so nothing is to add and remove them.
        command += ["--head", "--port", str(port), "--include-dashboard", "false", "--no-monitor"]
    else:
        command += ["--address", address]
    if options.host is not None or options.address is None:
        command += ["--node-ip-address", host]
    resources = {version_resource(config.root): 1}
    if config.class_database is not None:
        fault = missing_sandbox(config)
        if fault is not None and not host.startswith("127."):
            raise BadInput(
                tr("Programs cannot be locked in on this machine ({fault}), so it cannot serve classes.", fault=fault)
            )
        # Only such a node can serve classes.
        resources[PAGES] = PAGES_PER_PROCESSOR * processes
    command += ["--resources", json.dumps(resources)]
    use_token()
    if options.address is not None:
        reach(address)
    log = config.root / ".rosy" / "log" / f"cluster-node-{os.getpid()}.log"
    log.parent.mkdir(parents=True, exist_ok=True)
    environment = {**os.environ, **_SETTINGS, "ROSY_NODE_HOST": host}
    # Sockets and logs of Ray's processes; the path of a socket has at most 107 bytes (unix(7)).
    folder = Path(tempfile.mkdtemp(prefix=f"rosy-ray-{os.getpid()}-", dir="/tmp"))
    command += ["--temp-dir", str(folder)]
    interrupted = threading.Event()
    with contextlib.ExitStack() as stack:
        stack.callback(shutil.rmtree, folder, ignore_errors=True)
        try:
            _run(command, environment, log, interrupted, options, address, output)
        except ClusterFailed:
            # Ray's logs are kept.
            stack.pop_all()
            raise
    return 0


def _run(
    command: list[str],
    environment: dict[str, str],
    log: Path,
    interrupted: threading.Event,
    options: argparse.Namespace,
    address: str,
    output: Callable[[str], None],
) -> None:
    """Ray's processes, until an interrupt."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: interrupted.set())
    ray = _start(command, environment, log, interrupted)
    if ray is None:
        if interrupted.is_set():
            return
        if SECRET_REFUSED in log.read_bytes():
            raise other_secret(address)
        raise ClusterFailed(tr("The node could not start; what Ray says is in {file}.", file=str(log)))

    def interrupt(*_: object) -> None:
        interrupted.set()
        ray.terminate()

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, interrupt)
    if interrupted.is_set():
        ray.terminate()
    if options.address is None:
        output(in_terminal(tr("The cluster runs at {address}. Other machines join it with:", address=address)))
        output(f"  ./rosy start --cluster {address}")
        output(in_terminal(tr("They need its secret first, at the same place: {file}", file=str(token_file()))))
        output(in_terminal(tr("Programs are tested on it with:")))
        output(f"  ./rosy run FOLDER --rooms 100 --cluster {address}")
    else:
        output(in_terminal(tr("This machine is a node of the cluster at {address}.", address=address)))
    sys.stdout.flush()
    ray.wait()
    if not interrupted.is_set():
        raise ClusterFailed(tr("The node has ended; what Ray says is in {file}.", file=str(log)))


class ClusterFailed(RosyError):
    """A node could not start, or ended by itself."""


def _start(
    command: list[str], environment: dict[str, str], log: Path, interrupted: threading.Event
) -> subprocess.Popen[bytes] | None:
    """Ray's processes; ``None`` when they did not start."""
    for _ in range(_ATTEMPTS):
        with log.open("wb") as said:
            ray = subprocess.Popen(
                command, stdout=said, stderr=subprocess.STDOUT, start_new_session=True, env=environment
            )
        if _wait_until_ready(ray, log, interrupted):
            return ray
        # Also what it may have left.
        with contextlib.suppress(ProcessLookupError):
            os.killpg(ray.pid, signal.SIGKILL)
        ray.wait()
        if interrupted.is_set() or _TOO_SLOW not in log.read_bytes():
            return None
    return None


def _wait_until_ready(ray: subprocess.Popen[bytes], log: Path, interrupted: threading.Event) -> bool:
    """Whether Ray has started; it says so in a line of its log."""
    while ray.poll() is None and not interrupted.is_set():
        said = log.read_bytes()
        if b"Ray runtime started" in said:
            return True
        if SECRET_REFUSED in said:
            return False
        time.sleep(_POLL)
    return False


def _make_token() -> None:
    """The head's token: readable by its owner only; the one of an earlier start stays."""
    file = token_file()
    file.parent.mkdir(parents=True, exist_ok=True)
    try:
        descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    except FileExistsError:
        return
    with os.fdopen(descriptor, "w") as written:
        written.write(secrets.token_hex(32))
