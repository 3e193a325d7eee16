"""Classes of a cluster that cannot start: ``--class NAME`` says why and what to do, and an interrupt ends its wait."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from rosy_sim.bench.cluster.local_nodes import cluster_command
from rosy_sim.classroom.store.class_folder import open_class
from rosy_sim.classroom.store.database import SqliteDatabase
from rosy_sim.classroom.store.schema import MIGRATIONS

from ..conftest import PATIENCE
from ..test_cli import environment
from .ray_nodes import Node, needs_ray

__all__ = ["environment"]

UNREACHABLE = "postgresql://rosy@127.0.0.1:1/rosy"


def test_a_service_that_cannot_start_tells_its_actor_a_sentence(environment: dict[str, str], tmp_path: Path) -> None:
    with open_class(tmp_path, "7b"):
        pass
    database = SqliteDatabase(tmp_path / "7b" / "class.sqlite3")
    database.execute("PRAGMA user_version = 999")
    database.close()
    command = [sys.executable, "-m", "rosy_sim.cluster.class_service", "7b", "127.0.0.1", "http://127.0.0.1:8080"]
    store = {**environment, "ROSY_CLASS_DATABASE": f"sqlite:{tmp_path}"}
    # It would end with its input.
    with subprocess.Popen(command, env=store, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as service:
        assert service.stdout is not None
        assert json.loads(service.stdout.readline()) == {
            "type": "Failed",
            "id": "This class was opened by a newer Rosy: its version is {version}, and this Rosy reads up to "
            "{newest}. Open it with that one.",
            "arguments": {"version": 999, "newest": len(MIGRATIONS)},
        }
        assert service.wait(PATIENCE) == 1


@needs_ray
@pytest.mark.long
def test_a_class_without_a_node_or_a_database_says_so(environment: dict[str, str], tmp_path: Path) -> None:
    token = {**environment, "ROSY_CLUSTER_TOKEN": str(tmp_path / "token")}

    def begin(name: str, head: Node) -> subprocess.Popen[str]:
        command = cluster_command("node", "--cluster", head.address, "--class", name)
        return subprocess.Popen(
            command, env=token, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, process_group=0
        )

    def interrupt(begun: subprocess.Popen[str]) -> None:
        begun.send_signal(signal.SIGINT)
        _, wrong = begun.communicate(timeout=PATIENCE)
        assert (begun.returncode, "Traceback" in wrong) == (130, False)

    with Node(token) as head:
        waiting = begin("7b", head)
        assert waiting.stdout is not None
        assert "No node has room for the class now." in waiting.stdout.readline()
        interrupt(waiting)
        with Node({**token, "ROSY_CLASS_DATABASE": UNREACHABLE}, head, 2):
            # Begun before, it is tried again and again.
            waiting = begin("7b", head)
            assert waiting.stdout is not None
            said = [waiting.stdout.readline() for _ in range(3)]
            assert "cannot be reached" in said[1]
            assert "Start its server" in said[1]
            assert "tried again" in said[2]
            interrupt(waiting)
            # A new one is not begun.
            _, wrong = begin("7c", head).communicate(timeout=PATIENCE)
            assert "cannot be reached" in wrong
            assert "Traceback" not in wrong
            gone = subprocess.run(
                cluster_command("node", "--cluster", head.address, "--class", "7c", "--end"),
                env=token,
                capture_output=True,
                text=True,
                check=False,
            )
            assert "No node serves a class called 7c" in gone.stderr
