"""
``./rosy run … --rooms N --cluster ADDRESS`` on real Ray nodes: the same report as on one machine, also when a node is
lost, for hundreds of runs (nightly 2,000); programs that end workers; an interrupt; and what is refused.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
from pathlib import Path
from typing import Any

import pytest

from rosy_sim.bench.cluster.local_nodes import cluster_command
from rosy_sim.bench.cluster.rooms import Grading, programs
from rosy_sim.cluster.node import use_token
from rosy_sim.config import discover
from rosy_sim.errors import BadInput

from ..conftest import PATIENCE
from ..extent import NIGHTLY
from ..processes import await_begin, await_end
from ..test_cli import Here, environment, here, one_sentence, rosy
from .ray_nodes import CLUSTER_PYTHON, Node, needs_ray

__all__ = ["environment", "here"]


SOURCES = str(Path(__file__).resolve().parents[2])


@pytest.fixture
def token(environment: dict[str, str], tmp_path: Path) -> dict[str, str]:
    """The environment of a cluster with a secret of its own."""
    return {**environment, "ROSY_CLUSTER_TOKEN": str(tmp_path / "token")}


def on_cluster(environment: dict[str, str], head: Node, *arguments: object) -> subprocess.Popen[str]:
    command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", "run", *map(str, arguments), "--cluster", head.address]
    return subprocess.Popen(
        command,
        env=environment,
        cwd=environment["ROSY_ROOT"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        process_group=0,
    )


def told(running: subprocess.Popen[str]) -> tuple[int, str]:
    said, wrong = running.communicate(timeout=PATIENCE)
    assert wrong.endswith("the sandbox is turned off.\n")
    return running.returncode, said


def scripts(folder: Path, texts: dict[str, str]) -> None:
    for name, script in texts.items():
        (folder / "class" / name).mkdir(parents=True)
        (folder / "class" / name / "p.hs").write_text(script)


def temporary_folders(node: Node) -> list[Path]:
    """Ray's sockets and logs of a node."""
    return list(Path("/tmp").glob(f"rosy-ray-{node.pid}-*"))


@needs_ray
@pytest.mark.long
def test_a_lost_node_costs_no_result(token: dict[str, str], tmp_path: Path) -> None:
    # Each trial of the last one takes as long as the limit of a step, 5 s, so that the second node comes to try some.
    waits = {"eve": "hang@1"}
    scripts(tmp_path, {"ann": "done@1", "bob": "drive:0.5", "cem": "refuse", "dora": "drive:0.2 bump", **waits})
    rooms = 6
    test = ("class", "--rooms", rooms, "--seconds", 15, "--hold", "never-pushes", "1", "s", "--json")
    alone = rosy(token, "run", *test)
    with Node(token) as head, Node(token, head) as second:
        running = on_cluster(token, head, *test)
        assert await_begin(second.trial_processes, running), running.communicate(timeout=PATIENCE)
        second.kill()
        assert told(running) == (3, alone.stdout)

        # A program that ends its worker is tried again, and then named; the others have their results.
        scripts(tmp_path / "odd", {"ann": "done@1", "eve": "die"})
        status, said = told(on_cluster(token, head, tmp_path / "odd" / "class", "--rooms", 2, "--json"))
        reports: list[dict[str, Any]] = json.loads(said)["programs"]
        assert status == 3
        assert [len(report["rooms"]) for report in reports] == [2, 0]
        assert ["lost" in report for report in reports] == [False, True]

        assert temporary_folders(head)
        # An interrupt leaves nothing on the nodes. What the client before has left ends first.
        await_end(head.trial_processes(), PATIENCE)
        (tmp_path / "slow.hs").write_text("drive:0.1 hang@100")
        running = on_cluster(token, head, "slow.hs", "--rooms", 50)
        busy = await_begin(head.trial_processes, running)
        os.killpg(running.pid, signal.SIGINT)
        running.communicate(timeout=PATIENCE)
        assert running.returncode == 130
        await_end(busy, PATIENCE)

        # A client without the secret is refused.
        (tmp_path / "token").write_text("0" * 64)
        stranger = on_cluster(token, head, "slow.hs", "--rooms", 2)
        said, wrong = stranger.communicate(timeout=PATIENCE)
        assert (stranger.returncode, said) == (2, "")
        assert wrong.splitlines()[-1].startswith(f"rosy: The cluster at {head.address} has another secret. Copy ")
        assert "InvalidAuthToken" not in wrong
        command = cluster_command("node", "--cluster", head.address, "--host", "127.0.0.1")
        joining = subprocess.run(command, env=token, capture_output=True, text=True, check=False)
        assert (joining.returncode, joining.stdout) == (2, "")
        assert "has another secret" in joining.stderr
    # An interrupt left nothing of the head on the disk either.
    assert not temporary_folders(head)


@needs_ray
@pytest.mark.real
@pytest.mark.long
@pytest.mark.skipif(not discover().worker, reason="the worker is not built")
def test_many_runs_are_graded_while_a_node_is_killed_and_another_joins(tmp_path: Path) -> None:
    secret = {**os.environ, "LC_ALL": "C.UTF-8", "ROSY_CLUSTER_TOKEN": str(tmp_path / "token"), "PYTHONPATH": SOURCES}
    # In the ordinary run as many as it takes until another node has joined.
    count, rooms = (40, 50) if NIGHTLY else (20, 50)
    grading = Grading(tmp_path / "homework", rooms=rooms, seconds=1.0, environment=secret)
    programs(grading.folder, count)
    alone = grading.alone(2)
    with Node(secret) as head, Node(secret, head) as second, Node(secret, head) as lost:
        cluster = grading.with_loss([head, second, lost], alone.spent / 10)
    assert cluster.loss == "one joined"
    assert (cluster.status, cluster.answer) == (alone.status, alone.answer)
    assert sum(len(report["rooms"]) for report in json.loads(cluster.answer)["programs"]) == count * rooms
    # Shown by `pytest -s`.
    for where, graded in (("one machine", alone), ("the cluster", cluster)):
        cost = graded.spent / (count * rooms) * 1e3
        print(f"{where}: {count * rooms / graded.took:.1f} runs a second, {cost:.0f} ms of processor time each")
    print(f"load average {os.getloadavg()[0]:.1f}")


def test_a_program_that_ends_its_worker_twice_is_named(environment: dict[str, str], tmp_path: Path) -> None:
    scripts(tmp_path, {"ann": "done@1", "eve": "die", "fay": "done@1"})
    done = rosy(environment, "run", "class", "--rooms", 2, "--hold", "never-falls")
    assert done.returncode == 2
    first, second, third = done.stdout.splitlines()
    assert first.endswith("ann/p.hs: 2 of 2 rooms passed.")
    assert "eve/p.hs: this program ended the compiler part of Rosy twice" in second
    assert third.endswith("fay/p.hs: 2 of 2 rooms passed.")


def test_without_the_secret_nothing_is_tried(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("ROSY_CLUSTER_TOKEN", str(tmp_path / "none"))
    with pytest.raises(BadInput, match=r"Copy .*none from the machine"):
        use_token()


@pytest.mark.parametrize(
    "command",
    [
        ["run", "p.hs", "--cluster", "127.0.0.1:6379"],
        ["node", "--cluster", "--port", "0"],
        ["node", "--cluster", "--processes", "0"],
        ["node", "--cluster", "127.0.0.1:6379", "--class"],
        ["node", "--cluster", "127.0.0.1:6379", "--class", "7b", "--pages"],
        ["node", "--cluster", "127.0.0.1:6379", "--end"],
        ["node", "--cluster", "127.0.0.1:6379", "--origin", "http://rosy.example"],
        ["node", "--cluster", "127.0.0.1:6379", "--class", "7b", "--origin", "rosy.example"],
        ["node", "--cluster", "127.0.0.1:6379", "--class", "7b", "--origin", "http://rosy.example/rosy"],
    ],
)
def test_a_bad_option_gives_one_sentence(command: list[str], here: Here, tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("done@1")
    one_sentence(here(*command))


@needs_ray
def test_a_cluster_that_is_not_there_is_named(token: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "p.hs").write_text("done@1")
    (tmp_path / "token").write_text("0" * 64)
    for words in (("run", "p.hs", "--rooms", "2"), ("node",), ("node", "--class", "7b")):
        command = [str(CLUSTER_PYTHON), "-m", "rosy_sim", *words, "--cluster", "127.0.0.1:1"]
        done = subprocess.run(command, env=token, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 2
        assert "No cluster answers at 127.0.0.1:1 (Connection refused)" in done.stderr.splitlines()[-1]
