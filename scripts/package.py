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

from rosy_sim.sentences.sentence import sentence_of, tr
from rosy_sim.sentences.wording import in_terminal

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
        print(f"rosy: {in_terminal(tr('{path} is not a folder.', path=given.output))}", file=sys.stderr)
        return 1
    try:
        if given.kind != "stick":
            with tempfile.TemporaryDirectory(prefix="rosy-package-") as work:
                package = make_deb(ROOT, Path(work), given.output)
            command = f"sudo apt install {_argument(package)}"
            print(in_terminal(tr("{file} ({megabytes} MB). Install it with: {command}", file=package, megabytes=_megabytes(package), command=command)))
        if given.kind != "deb":
            folder = given.output / "rosy-stick"
            if folder.exists():
                raise TreeError(tr("{path} is already there: remove it first.", path=folder))
            try:
                make_folder(ROOT, folder)
            except BaseException:
                shutil.rmtree(folder, ignore_errors=True)
                raise
            command = "cd rosy-stick && ./rosy start"
            size = _megabytes(folder)
            print(in_terminal(tr("{file} ({megabytes} MB). Copy it to a stick; on the other machine: {command}", file=folder, megabytes=size, command=command)))
    except (TreeError, OSError) as error:
        print(f"rosy: {in_terminal(tr('nothing was packaged: {why}', why=sentence_of(error)))}", file=sys.stderr)
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
