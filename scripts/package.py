"""
`./rosy package`: a Debian package of Rosy for this system, and a folder that starts without internet and without installation.

Writes both into the folder given (default: the current one) and prints how each is used.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

from installation.debian import make_deb
from installation.installed_tree import TreeError
from installation.portable_folder import make_folder

ROOT = Path(__file__).resolve().parent.parent


def main(arguments: list[str]) -> int:
    """Exit status: 0, or 1 when a part is missing."""
    parser = argparse.ArgumentParser(prog="rosy package", add_help=False)
    parser.add_argument("kind", nargs="?", choices=("deb", "stick"), help="only one of the two")
    parser.add_argument("-o", "--output", type=Path, default=Path.cwd(), help="folder to write to")
    given = parser.parse_args(arguments)
    if not given.output.is_dir():
        print(f"rosy: {given.output} is not a folder.", file=sys.stderr)
        return 1
    try:
        if given.kind != "stick":
            with tempfile.TemporaryDirectory(prefix="rosy-package-") as work:
                package = make_deb(ROOT, Path(work), given.output)
            print(f"{package} ({_megabytes(package)} MB). Install it with: sudo apt install {_argument(package)}")
        if given.kind != "deb":
            folder = given.output / "rosy-stick"
            if folder.exists():
                raise TreeError(f"{folder} is already there: remove it first.")
            try:
                make_folder(ROOT, folder)
            except BaseException:
                shutil.rmtree(folder, ignore_errors=True)
                raise
            print(f"{folder} ({_megabytes(folder)} MB). Copy it to a stick; on the other machine: cd rosy-stick && ./rosy start")
    except (TreeError, OSError) as error:
        print(f"rosy: nothing was packaged: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def _megabytes(path: Path) -> int:
    files = path.rglob("*") if path.is_dir() else [path]
    return round(sum(file.stat().st_size for file in files if file.is_file()) / 1e6)


def _argument(package: Path) -> str:
    """The file as apt wants it: with a slash, else it would look for a package of that name."""
    text = str(package)
    return text if "/" in text else f"./{text}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
