"""Version of a machine's Rosy: the same for the same sources, another when what runs programs has changed."""

from __future__ import annotations

from pathlib import Path

from rosy_sim.cluster.version import version_resource


def installed(root: Path) -> Path:
    for name, text in (("rosy.cabal", "1"), ("protocol/p.json", "{}"), ("sim-service/rosy_sim/run/a.py", "x")):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return root


def test_it_is_that_of_the_sources_which_run_programs(tmp_path: Path) -> None:
    first, second = installed(tmp_path / "a"), installed(tmp_path / "b")
    assert version_resource(first) == version_resource(second)
    (second / "README.md").write_text("a page")
    (second / "sim-service/rosy_sim/run/a.pyc").write_bytes(b"\0")
    assert version_resource(first) == version_resource(second)
    (second / "sim-service/rosy_sim/run/b.py").write_text("y")
    assert version_resource(first) != version_resource(second)
