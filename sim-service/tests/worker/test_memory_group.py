"""The control group of a worker: where it is made, what its limit does, and that nothing of it is left."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from rosy_sim.config import Config
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.worker.launcher import launch
from rosy_sim.worker.memory_group import create_memory_group

from ..conftest import PATIENCE


def tree(folder: Path, membership: str, files: dict[str, str]) -> tuple[Path, Path]:
    """Control groups as the kernel shows them, and the file that names ours."""
    for name, text in files.items():
        path = folder / "groups" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    (folder / "own").write_text(membership)
    return folder / "groups", folder / "own"


PROCS = "cgroup.procs"
GIVES = "cgroup.subtree_control"


@pytest.mark.parametrize(
    ("membership", "files", "parent", "limit_file"),
    [
        # Version 1: below the own group.
        ("4:memory:/a\n0::/\n", {f"memory/a/{PROCS}": "1\n"}, "memory/a", "memory.limit_in_bytes"),
        # Version 2: below the own group where that gives memory to its children, else beside it.
        ("0::/a/b\n", {f"a/b/{GIVES}": "cpu memory\n", f"a/b/{PROCS}": "", f"a/{PROCS}": ""}, "a/b", "memory.max"),
        (
            "0::/a/b\n",
            {f"a/b/{GIVES}": "\n", "a/b/memory.max": "max\n", f"a/{GIVES}": "memory pids\n", f"a/{PROCS}": ""},
            "a",
            "memory.max",
        ),
        # Hybrid: the memory controller is in version 1.
        ("0::/\n4:memory:/a\n", {f"memory/a/{PROCS}": "", GIVES: "pids\n"}, "memory/a", "memory.limit_in_bytes"),
    ],
)
def test_a_group_is_made_where_its_limit_holds(
    membership: str, files: dict[str, str], parent: str, limit_file: str, tmp_path: Path
) -> None:
    groups, own = tree(tmp_path, membership, files)
    group = create_memory_group(1000, groups, own)
    assert group is not None
    assert group.folder.parent == groups / parent
    assert (group.folder / limit_file).read_text() == "1000"
    assert group.members == group.folder / PROCS


@pytest.mark.parametrize(
    ("membership", "files"),
    [
        ("", {}),
        ("0::/gone\n", {}),
        # Nobody gives memory to children.
        ("0::/a\n", {f"a/{GIVES}": "pids\n", GIVES: "cpu\n", PROCS: ""}),
        # The own group has a limit, from which the programs would escape.
        ("0::/a/b\n", {f"a/b/{GIVES}": "", "a/b/memory.max": "4000\n", f"a/{GIVES}": "memory\n", f"a/{PROCS}": ""}),
        # Version 1 without the memory controller.
        ("4:cpu,cpuacct:/a\n", {f"cpu/a/{PROCS}": ""}),
    ],
)
def test_there_is_none_where_there_cannot_be_one(membership: str, files: dict[str, str], tmp_path: Path) -> None:
    groups, own = tree(tmp_path, membership, files)
    assert create_memory_group(1000, groups, own) is None
    assert not list(tmp_path.rglob("rosy-programs-*"))


def test_groups_of_services_that_were_killed_are_removed(tmp_path: Path) -> None:
    groups, own = tree(tmp_path, "4:memory:/a\n", {f"memory/a/{PROCS}": ""})
    killed = subprocess.Popen(["true"])
    killed.wait(PATIENCE)
    names = (f"{killed.pid}-1", f"{killed.pid}-2", f"{os.getpid()}-0")
    empty, used, new = (groups / "memory" / "a" / f"rosy-programs-{name}" for name in names)
    for folder in (empty, used, new):
        folder.mkdir()
    (used / "held").touch()
    assert create_memory_group(1000, groups, own) is not None
    # A service that lives may be about to start the first process of its group.
    assert (empty.exists(), used.exists(), new.exists()) == (False, True, True)


def test_the_kernel_ends_what_takes_more_than_the_limit() -> None:
    group = create_memory_group(64 * 1024 * 1024)
    if group is None:
        pytest.skip("no control group may be made here")
    join = f"import os; open({str(group.members)!r}, 'w').write(str(os.getpid()))"
    try:
        for megabytes, code in ((8, 0), (256, -9)):
            taken = subprocess.run(
                [sys.executable, "-c", f"{join}; len(bytes(1) * {megabytes << 20})"], timeout=PATIENCE, check=False
            )
            assert (megabytes, taken.returncode) == (megabytes, code)
    finally:
        group.remove()
    assert not group.folder.exists()


def test_a_worker_and_its_programs_are_in_one_group_and_leave_none(config: Config) -> None:
    process = launch(config)
    group = process.group
    try:
        if group is None:
            pytest.skip("no control group may be made here")
        # The worker has answered: whatever started it is over.
        assert process.socket.recv(1)
        members = {int(pid) for pid in group.members.read_text().split()}
        assert process.pid in members
        for pid in members:
            assert group.folder.name in Path(f"/proc/{pid}/cgroup").read_text()
    finally:
        process.kill()
        os.waitpid(process.pid, 0)
        process.leave_nothing()
        process.socket.close()
    assert not group.folder.exists()


def test_a_command_leaves_no_group(config: Config) -> None:
    group = create_memory_group(1 << 30)
    if group is None:
        pytest.skip("no control group may be made here")
    group.remove()
    # The workers of other tests in this process, which may live on, have groups as well.
    others = groups_beside(group.folder)
    with BlockingWorker(config) as worker:
        worker.ready()
        own = groups_beside(group.folder) - others
        assert own
    assert not own & groups_beside(group.folder)


def groups_beside(folder: Path) -> set[Path]:
    """The groups that this process has made."""
    return set(folder.parent.glob(f"rosy-programs-{os.getpid()}-*"))
