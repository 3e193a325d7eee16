"""
hlint or ormolu over the Haskell sources, where the tool has the version that the sources follow.

In: the tool, its version (`3.3` is any 3.3.x) and its arguments. Out: the tool's output and exit status over all sources, or
OTHER_VERSION and a line with both versions: other versions find other things, and write the same program in another way.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from testing.counts import OTHER_VERSION
from tracked_files import haskell_sources

ROOT = Path(__file__).resolve().parent.parent


def main(arguments: Sequence[str]) -> int:
    tool, version, *options = arguments
    said = subprocess.run([tool, "--version"], capture_output=True, check=True, text=True).stdout
    found = re.search(r"\d+(?:\.\d+)+", said)
    if found is None or not f"{found[0]}.".startswith(f"{version}."):
        print(f"the sources follow {tool} {version}, and here it is {found[0] if found else 'of no known version'}")
        return OTHER_VERSION
    return subprocess.run([tool, *options, *haskell_sources(ROOT)], cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
