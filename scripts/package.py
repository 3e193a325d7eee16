"""
`./rosy package`: what is given away of this Rosy, for this kind of machine.

A Debian package, a folder for a memory stick, a distribution for Windows' WSL, a container image; `all` makes them with their checksums and
a list of what they hold. Writes into the folder given (default: the current one) and prints how each is used.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import shutil
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path

from rosy_sim.sentences.sentence import Sentence, sentence_of, tr
from rosy_sim.sentences.wording import in_terminal
from rosy_sim.version import VERSION

from installation.container_image import SECCOMP, make_image
from installation.debian import make_deb
from installation.installed_tree import System, TreeError, source_date, this_system
from installation.portable_folder import make_folder
from installation.root_filesystem import make_base, write_folder
from installation.wsl_distribution import make_wsl

ROOT = Path(__file__).resolve().parent.parent

KINDS = ("deb", "stick", "wsl", "image", "all")


def main(arguments: list[str]) -> int:
    """Exit status: 0, or 1 when a part is missing."""
    parser = argparse.ArgumentParser(prog="rosy package", add_help=False)
    parser.add_argument("kind", nargs="?", choices=KINDS, help="only one of them; all with checksums and a list of parts")
    parser.add_argument("-o", "--output", type=Path, default=Path.cwd(), help="folder to write to")
    given = parser.parse_args(arguments)
    try:
        given.output.mkdir(parents=True, exist_ok=True)
    except OSError:
        print(f"rosy: {in_terminal(tr('{path} is not a folder.', path=given.output))}", file=sys.stderr)
        return 1
    try:
        _make(given.kind, given.output, this_system())
    except (TreeError, OSError) as error:
        print(f"rosy: {in_terminal(tr('nothing was packaged: {why}', why=sentence_of(error)))}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0


def _make(kind: str | None, output: Path, system: System) -> None:
    epoch = source_date(ROOT)
    # dpkg-deb(1): no time in the package is later.
    os.environ["SOURCE_DATE_EPOCH"] = str(epoch)
    made: list[Path] = []
    if kind in (None, "deb", "all"):
        made.append(_deb(output, system))
    if kind in (None, "stick"):
        _stick(output, system)
    if kind not in ("wsl", "image", "all"):
        return
    with ExitStack() as stack:
        work = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="rosy-package-", dir=output)))
        base, tree = work / "base.tar", work / f"rosy-stick-{system.tag}-{system.architecture}"
        _say(tr("Making a small system with Rosy in it; this takes a few minutes and downloads about 50 MB."))
        make_base(base, epoch)
        make_folder(ROOT, tree)
        if kind == "all":
            made.append(_stick_archive(tree, output, system, epoch))
        if kind in ("wsl", "all"):
            made.append(_wsl(base, tree, output, system, epoch))
        if kind in ("image", "all"):
            made += [_image(base, tree, output, system, epoch), output / SECCOMP]
        if kind == "all":
            made.append(_parts(base, tree, output, system, epoch))
            _checksums(made, output)


def _deb(output: Path, system: System) -> Path:
    _say(tr("Making the Debian package; this takes a few minutes."))
    with tempfile.TemporaryDirectory(prefix="rosy-package-") as work:
        package = make_deb(ROOT, Path(work), output)
    command = f"sudo apt install {_argument(package)}"
    size = _megabytes(package)
    _result(tr("{file} ({megabytes} MB), for {system}. Install it with: {command}", file=package, system=system.name, megabytes=size, command=command))
    return package


def _stick(output: Path, system: System) -> None:
    folder = output / f"rosy-stick-{system.tag}-{system.architecture}"
    if folder.exists():
        raise TreeError(tr("{path} is already there: remove it first.", path=folder))
    _say(tr("Making the folder for a memory stick; this takes a few minutes."))
    try:
        make_folder(ROOT, folder)
    except BaseException:
        shutil.rmtree(folder, ignore_errors=True)
        raise
    command = f"cd {folder.name} && ./rosy start"
    size = _megabytes(folder)
    _result(
        tr(
            "{file} ({megabytes} MB), for {system} and newer. Copy it to a stick; on the other machine: {command}",
            file=folder,
            system=system.name,
            megabytes=size,
            command=command,
        )
    )


def _stick_archive(tree: Path, output: Path, system: System, epoch: int) -> Path:
    archive = output / f"rosy-stick-{VERSION}-{system.tag}-{system.architecture}.tar.gz"
    write_folder(tree, archive, epoch)
    command = f"tar -xzf {archive.name}"
    size = _megabytes(archive)
    _result(
        tr(
            "{file} ({megabytes} MB), for a stick, for {system} and newer. Unpack it there: {command}",
            file=archive,
            system=system.name,
            megabytes=size,
            command=command,
        )
    )
    return archive


def _wsl(base: Path, tree: Path, output: Path, system: System, epoch: int) -> Path:
    distribution = make_wsl(base, tree, output, system.architecture, epoch)
    size = _megabytes(distribution)
    _result(tr("{file} ({megabytes} MB), for Windows with WSL 2.4.4 or newer: a double click installs it.", file=distribution, megabytes=size))
    return distribution


def _image(base: Path, tree: Path, output: Path, system: System, epoch: int) -> Path:
    image = make_image(base, tree, output, system.architecture, epoch)
    command = f"podman load -i {image}"
    size = _megabytes(image)
    _result(
        tr(
            "{file} ({megabytes} MB), for Docker, Podman and Kubernetes; docs/server.md says how to start it. Load it with: {command}",
            file=image,
            megabytes=size,
            command=command,
        )
    )
    return image


def _parts(base: Path, tree: Path, output: Path, system: System, epoch: int) -> Path:
    # Only `all` needs the library behind it.
    from installation import bill_of_materials as bill

    distribution = system.tag.rstrip("0123456789.")
    parts = {*bill.debian_parts(base, distribution), *bill.owners_of_libraries(tree, distribution), *bill.haskell_parts(tree)}
    parts |= {*bill.python_parts(ROOT / "sim-service/requirements.lock"), *bill.npm_parts(ROOT / "package-lock.json")}
    file = output / f"rosy-{VERSION}_{system.architecture}.cdx.json"
    file.write_text(bill.bill_of_materials(parts, epoch))
    _result(tr("{file}: what of others these files hold, {count} packages (CycloneDX).", file=file, count=len(parts)))
    return file


def _checksums(files: list[Path], output: Path) -> None:
    """As sha256sum(1) writes and checks them."""
    lines = []
    for file in sorted(files):
        with file.open("rb") as opened:
            lines.append(f"{hashlib.file_digest(opened, 'sha256').hexdigest()}  {file.name}\n")
    (output / "SHA256SUMS").write_text("".join(lines))
    _result(tr("{file}: check the files with {command}.", file=output / "SHA256SUMS", command="sha256sum -c SHA256SUMS"))


def _say(sentence: Sentence) -> None:
    """Progress, beside the results on standard output."""
    print(in_terminal(sentence), file=sys.stderr, flush=True)


def _result(sentence: Sentence) -> None:
    print(in_terminal(sentence), flush=True)


def _megabytes(path: Path) -> int:
    files = path.rglob("*") if path.is_dir() else [path]
    return round(sum(file.stat().st_size for file in files if file.is_file()) / 1e6)


def _argument(package: Path) -> str:
    """The file as apt wants it: with a slash, else it would look for a package of that name."""
    text = str(package)
    return text if "/" in text else f"./{text}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
