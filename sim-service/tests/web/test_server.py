"""Where the worker's sandbox cannot be built, and who can build it."""

from __future__ import annotations

import asyncio
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from starlette.types import Receive, Scope, Send

from rosy_sim.config import Config, discover
from rosy_sim.errors import BadInput
from rosy_sim.sentences.sentence import verbatim
from rosy_sim.web import server as serving
from rosy_sim.worker import launcher
from rosy_sim.worker.launcher import _sandbox, sandbox_fault

from ..conftest import PATIENCE

NOBODY = "65534"
"""The user and the group that own nothing on a Debian system."""


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.0.2.1", "example.invalid"])
def test_without_a_sandbox_only_this_machine_is_served_and_the_reason_is_told(host: str, config: Config) -> None:
    with pytest.raises(BadInput, match=r"cannot be locked in on this machine \(the sandbox is turned off\)"):
        serving.serve(config, host, 0, open_browser=False, unprotected=False)


def test_the_reason_is_the_kernels_own(config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(launcher, "sandbox_fault", lambda: verbatim("bwrap: No permissions to create new namespace"))
    with pytest.raises(BadInput, match=r"No permissions to create new namespace.*--unprotected"):
        serving.serve(replace(config, sandbox=True), "0.0.0.0", 0, open_browser=False, unprotected=False)


@pytest.mark.skipif(not discover().worker, reason="the worker is not built")
def test_a_kernel_that_forbids_namespaces_is_noticed() -> None:
    kinds = "user pid net mnt ipc uts cgroup"
    forbid = f'for kind in {kinds}; do echo 0 > /proc/sys/user/max_"$kind"_namespaces; done; exec "$@"'
    unable = ["unshare", "--user", "--map-root-user", "sh", "-c"]
    if (
        shutil.which("unshare") is None
        or subprocess.run([*unable, "true"], capture_output=True, check=False).returncode
    ):
        pytest.skip("this kernel does not allow it to be tried")
    command = [sys.executable, "-m", "rosy_sim", "serve", "--no-browser", "--port", "0", "--host", "0.0.0.0"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parents[2])}
    done = subprocess.run(
        [*unable, forbid, "sh", *command],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE,
    )
    assert done.returncode != 0
    assert "Programs cannot be locked in on this machine (bwrap: Creating new namespace failed" in done.stderr
    assert "so Rosy only serves this machine itself; leave out --host, or add --unprotected" in done.stderr


def test_who_insists_is_served(config: Config) -> None:
    # It comes as far as the address, which is not ours.
    with pytest.raises(BadInput, match="no address called"):
        serving.serve(config, "example.invalid", 0, open_browser=False, unprotected=True)


@pytest.mark.parametrize("host", ["127.0.0.1", "::1", "localhost"])
def test_this_machine_itself_is_always_served(host: str, config: Config) -> None:
    with pytest.raises(BadInput, match="There is no port"):
        serving.serve(config, host, 70000, open_browser=False, unprotected=False)


@pytest.mark.skipif(sandbox_fault() is not None, reason="this machine cannot build the sandbox")
@pytest.mark.parametrize("user", ["ourselves", "nobody"])
def test_the_sandbox_is_built_by_an_administrator_and_by_anybody_else(user: str) -> None:
    become = ["setpriv", "--reuid", NOBODY, "--regid", NOBODY, "--clear-groups"] if user == "nobody" else []
    if become and (os.getuid() != 0 or shutil.which("setpriv") is None):
        pytest.skip("only an administrator can try it as somebody else")
    inside = "ls /; touch /usr/x 2>&1; grep CapEff /proc/self/status"
    sandbox = _sandbox(replace(discover(), visible=()))
    done = subprocess.run([*become, *sandbox, "/bin/sh", "-c", inside], capture_output=True, text=True, check=False)
    if become and done.returncode != 0 and "namespace" in done.stderr:
        pytest.skip("this kernel does not let ordinary users make namespaces")
    said = done.stdout
    assert done.returncode == 0, done.stderr
    assert "home" not in said
    assert "work" not in said
    assert "Read-only file system" in said
    assert "CapEff:\t0000000000000000" in said


def test_a_request_that_is_open_when_the_service_ends_leaves_no_traceback() -> None:
    async def endless(_scope: Scope, _receive: Receive, _send: Send) -> None:
        await asyncio.Event().wait()

    async def tell(kind: str) -> None:
        served = serving._without_cancellations(endless)({"type": kind}, _none, _none)
        task = asyncio.ensure_future(served)
        await asyncio.sleep(0)
        task.cancel()
        await task

    asyncio.run(tell("http"))
    asyncio.run(tell("websocket"))
    with pytest.raises(asyncio.CancelledError):
        asyncio.run(tell("lifespan"))


async def _none(*_: object) -> Any:
    raise AssertionError
