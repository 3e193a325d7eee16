"""A session in a real editor: Neovim's own client shows the diagnostic, applies its fix, renames, runs the program."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from rosy_sim.config import discover

from ..conftest import PATIENCE

ROOT = Path(__file__).resolve().parents[3]

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not discover().worker, reason="the worker is not built"),
    pytest.mark.skipif(shutil.which("nvim") is None, reason="Neovim is not installed"),
    pytest.mark.skipif(
        shutil.which("node") is None or not (ROOT / "codegen" / "dist" / "cli.js").exists(),
        reason="codegen's command line is not built",
    ),
]


def test_a_session_in_neovim(tmp_path: Path) -> None:
    program = tmp_path / "program.hs"
    program.write_text('-- 🤖\ngo :: Velocity -> Say\ngo _ = Say ("🤖" ++ shwo 1)\n\nmain = simulate go\n', "utf-8")
    out = tmp_path / "out.json"
    command = [sys.executable, "-m", "rosy_sim", "lsp"]
    kept = {
        **os.environ,
        "HOME": str(tmp_path),
        "XDG_STATE_HOME": str(tmp_path),
        "PYTHONPATH": str(ROOT / "sim-service"),
        "ROSY_ROOT": str(ROOT),
        "ROSY_COMMAND": json.dumps(command),
        "ROSY_OUT": str(out),
    }
    script = Path(__file__).with_name("neovim.lua")
    done = subprocess.run(
        ["nvim", "--headless", "--clean", str(program), "-c", f"luafile {script}", "-c", "cquit"],
        env=kept,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        stdin=subprocess.DEVNULL,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    seen = json.loads(out.read_text("utf-8"))
    # Neovim counts columns in bytes; the emoji before the name has four.
    assert (seen["diagnostic"]["line"], seen["diagnostic"]["column"]) == (2, len('go _ = Say ("🤖" ++ '.encode()))
    assert "shwo" in seen["diagnostic"]["message"]
    assert seen["text"] == '-- 🤖\nahead :: Velocity -> Say\nahead _ = Say ("🤖" ++ show 1)\n\nmain = simulate ahead'
    assert seen["lens"] == "▶ Run in the simulator"
    assert (seen["ended"], seen["problems"]) == ("time", [])
