"""The version of this Rosy, as Semantic Versioning has it, such as 1.0.0. Its only source is ``rosy.cabal``."""

from __future__ import annotations

import re
from pathlib import Path

__all__ = ["VERSION"]

_CABAL_FILE = Path(__file__).resolve().parents[2] / "rosy.cabal"

VERSION = re.findall(r"^version:\s*(\S+)", _CABAL_FILE.read_text(), re.MULTILINE)[0]
