"""
List of the repository's own files: what git tracks, or, in a copy without git, every file that .gitignore does not name.

In: the root folder. Out: sorted relative paths of files that exist. It reads directory entries only, never file contents.
"""

from __future__ import annotations

import fnmatch
import os
import subprocess
from pathlib import Path

__all__ = ["haskell_sources", "tracked_files"]

# Haskell files that are test inputs, generated code, examples or the work of others: they are neither formatted nor linted.
_NOT_FORMATTED = ("*/generated/*", "*/gallery/*", "*/pupils/*", "*/attacks/*", "examples/*", "codegen/corpus/*", "*/test-ros/roshask/*")


def tracked_files(root: Path) -> list[Path]:
    """All files of the repository, relative to `root`. Works in a ZIP download and in a folder that another user owns."""
    try:
        listed = subprocess.run(
            # git refuses a repository of another user unless it is told that the folder is safe.
            ["git", "-c", f"safe.directory={root}", "ls-files", "-z"],
            cwd=root,
            capture_output=True,
            check=True,
            text=True,
        )
    except (OSError, subprocess.CalledProcessError):
        return _walk(root)
    if not (root / ".git").exists():
        # The folder lies inside another repository, which knows nothing of these files.
        return _walk(root)
    return sorted(path for path in map(Path, filter(None, listed.stdout.split("\0"))) if (root / path).is_file())


def _walk(root: Path) -> list[Path]:
    ignored = [line.strip().rstrip("/") for line in (root / ".gitignore").read_text().splitlines() if line.strip()]

    def kept(name: str) -> bool:
        return name != ".git" and not any(fnmatch.fnmatch(name, pattern) for pattern in ignored)

    found: list[Path] = []
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(filter(kept, folders))
        found += [Path(folder, name).relative_to(root) for name in filter(kept, names)]
    return sorted(found)


def haskell_sources(root: Path) -> list[str]:
    """Haskell files under the formatter and the linter."""
    return [
        path.as_posix()
        for path in tracked_files(root)
        if path.suffix == ".hs" and not any(fnmatch.fnmatch(path.as_posix(), pattern) for pattern in _NOT_FORMATTED)
    ]


if __name__ == "__main__":
    print("\0".join(haskell_sources(Path(__file__).resolve().parent.parent)), end="")
