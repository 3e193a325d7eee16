"""Choice of the quick run: what depends on a change runs, safety always does, and what is left out is named."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from testing.quick import CROSSINGS, SAFE_PYTHON, SAFE_STORIES, changed_since, choose
from testing.scheduler import Suite
from testing.suites import suites

ROOT = Path(__file__).resolve().parents[2]


def chosen(tmp_path: Path, *changed: str) -> tuple[dict[str, Suite], str]:
    choice = choose(suites(tmp_path), ROOT, changed)
    return {suite.name: suite for suite in choice.suites}, "\n".join(choice.left_out)


@pytest.mark.parametrize("changed", ["README.md", "editor/src/views/room/camera.ts", "rosy-hs/src/Rosy/Loop.hs", "sim-service/rosy_sim/token_bucket.py"])
def test_safety_is_always_in_it(tmp_path: Path, changed: str) -> None:
    run, left_out = chosen(tmp_path, changed)
    # A suite that is not narrowed runs whole.
    assert "python" not in left_out or set(SAFE_PYTHON) <= set(run["python"].command)
    assert {f"/{name}.spec" for name in SAFE_STORIES} <= set(run["e2e"].command)
    assert "lint-py" in run


def test_a_module_runs_the_tests_that_import_it(tmp_path: Path) -> None:
    run, left_out = chosen(tmp_path, "sim-service/rosy_sim/token_bucket.py")
    assert "sim-service/tests/test_token_bucket.py" in run["python"].command
    assert "sim-service/tests/maps/test_scanned_room.py" not in run["python"].command
    assert "python: all that does not depend on the change" in left_out


def test_what_crosses_languages_runs_whole(tmp_path: Path) -> None:
    everything = {suite.name: suite for suite in suites(tmp_path)}
    run, _ = chosen(tmp_path, "protocol/robots/kobuki.json")
    for name in CROSSINGS["protocol/"]:
        assert run[name].command == everything[name].command


def test_each_suite_runs_whole_or_is_named(tmp_path: Path) -> None:
    run, left_out = chosen(tmp_path, "editor/src/views/room/camera.ts")
    everything = {suite.name: suite for suite in suites(tmp_path)}
    for name, suite in everything.items():
        assert (name in run and run[name].command == suite.command) or f"{name}: all" in left_out


def test_the_tables_name_what_exists() -> None:
    for path in (*CROSSINGS, *SAFE_PYTHON, *(f"e2e-tests/stories/{name}.spec.ts" for name in SAFE_STORIES)):
        assert (ROOT / path).exists(), path


def test_committed_uncommitted_and_new_files_have_changed(tmp_path: Path) -> None:
    def git(*words: str) -> None:
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=tmp_path, check=True, capture_output=True)

    git("init", "-q")
    for name in ("kept", "committed", "edited"):
        (tmp_path / name).write_text("1")
    git("add", ".")
    git("commit", "-qm", "first")
    git("tag", "base")
    (tmp_path / "committed").write_text("2")
    git("commit", "-qam", "second")
    (tmp_path / "edited").write_text("2")
    (tmp_path / "new").write_text("1")
    assert changed_since(tmp_path, "base") == ["committed", "edited", "new"]
    with pytest.raises(ValueError, match="nowhere"):
        changed_since(tmp_path, "nowhere")
