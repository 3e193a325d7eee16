"""A simulated robot, the programs that drive it and the page that shows it."""

from __future__ import annotations

from pathlib import Path

from .compiled_modules import install

__all__: list[str] = []

install(Path(__file__).parents[2] / ".rosy" / "compiled")
