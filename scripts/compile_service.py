"""
``compile_service.py FOLDER``: compiles the modules of the service that compute in each step (``rosy_sim.compiled_modules``).

Out: FOLDER with an extension for the interpreter that runs this. Needs mypyc, setuptools and `sim-service` on
Python's path, a C compiler and Python's headers.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from mypyc.build import mypycify
from rosy_sim.compiled_modules import MODULES, SOURCES, fingerprint
from setuptools import setup

ROOT = Path(__file__).parents[1]


__all__ = ["main"]


def main() -> int:
    """Write the folder; returns the exit status."""
    folder = Path(sys.argv[1]).absolute()
    compiled_from = fingerprint()
    os.chdir(ROOT / "sim-service")
    # What a loop of some thousand steps costs hardly differs between this level and the next; compiling takes longer there.
    os.environ["CFLAGS"] = "-g0 -O1"
    with tempfile.TemporaryDirectory() as temporary:
        extensions = mypycify(
            ["--config-file=pyproject.toml", f"--cache-dir={temporary}/mypy", *(f"rosy_sim/{name.replace('.', '/')}.py" for name in MODULES)],
            opt_level="1",
            debug_level="0",
            multi_file=True,
            target_dir=f"{temporary}/c",
        )
        setup(
            name="rosy-sim-compiled",
            packages=[],
            ext_modules=extensions,
            script_args=["build_ext", f"--build-lib={folder}", f"--build-temp={temporary}/build", f"--parallel={len(os.sched_getaffinity(0))}"],
        )
    # Last: without it nothing is taken from the folder.
    (folder / SOURCES).write_text(compiled_from)
    return 0


if __name__ == "__main__":
    sys.exit(main())
