"""The ceiling of memory: half of the smallest limit above the service."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosy_sim.memory_ceiling import memory_ceiling

MACHINE = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize(
    ("membership", "files", "ceiling"),
    [
        ("0::/user/rosy\n", {"user/rosy/memory.max": "max\n", "user/memory.max": "4000000\n"}, 2_000_000),
        ("0::/\n", {"memory.max": "6000000\n"}, 3_000_000),
        (
            "11:cpu,memory:/a\n0::/\n",
            {"memory/a/memory.limit_in_bytes": "1000000\n", "memory.max": "9000000"},
            500_000,
        ),
        ("3:memory:/\n", {"memory/memory.limit_in_bytes": "9223372036854771712\n"}, MACHINE // 2),
        ("0::/gone\n", {}, MACHINE // 2),
        ("", {}, MACHINE // 2),
    ],
)
def test_the_ceiling_is_half_of_the_smallest_limit(
    membership: str, files: dict[str, str], ceiling: int, tmp_path: Path
) -> None:
    for name, text in files.items():
        path = tmp_path / "groups" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    (tmp_path / "own").write_text(membership)
    assert memory_ceiling(tmp_path / "groups", tmp_path / "own") == ceiling


def test_a_system_without_control_groups_has_the_memory_of_the_machine(tmp_path: Path) -> None:
    assert memory_ceiling(tmp_path, tmp_path / "none") == MACHINE // 2
