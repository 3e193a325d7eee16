"""
Bare system in a folder: a Debian or Ubuntu made by mmdebstrap with nothing but what the README asks for, in which commands run.
"""

from __future__ import annotations

import hashlib
import os
import re
import shlex
import shutil
import subprocess
import urllib.request
from dataclasses import dataclass, field
from pathlib import Path

__all__ = ["System", "first_error", "keyring"]

PREREQUISITES = "git curl ca-certificates python3"
"""What the README asks for, and the certificates without which git and curl reach nothing."""

PASSED_ON = re.compile(r"(?i)^(https?_proxy|no_proxy|pip_\w+|npm_config_\w+|node_extra_ca_certs|ssl_cert_file|debian_frontend)$")
"""Variables by which a machine names its own way to the network."""


def first_error(log: str) -> str:
    """What apt says; the errors behind it are mmdebstrap's, that apt has failed."""
    errors = [line.removeprefix("E: ") for line in log.splitlines() if line.startswith("E: ")]
    return errors[0] if errors else ""


def keyring(distribution: str, folder: Path, package: dict[str, str] | None) -> Path:
    """
    The file with the keys of a distribution's packages: this system's, or else one taken out of ``package`` into ``folder``.

    A package whose SHA-256 is another, or that cannot be fetched, is not used: the file that is returned then does not exist.
    """
    name = f"{distribution}-archive-keyring.gpg"
    of_the_system, fetched = Path("/usr/share/keyrings", name), folder / "keyrings/usr/share/keyrings" / name
    if of_the_system.exists() or package is None:
        return of_the_system
    if not fetched.exists():
        file = folder / "keyring.deb"
        try:
            with urllib.request.urlopen(package["package"], timeout=60) as answer:
                file.write_bytes(answer.read())
        except OSError:
            return of_the_system
        if hashlib.sha256(file.read_bytes()).hexdigest() == package["sha256"]:
            subprocess.run(["dpkg-deb", "-x", str(file), str(folder / "keyrings")], check=True)
    return fetched


@dataclass
class System:
    """A bare system in a folder, in which commands run as root or as a user."""

    release: dict[str, str]
    folder: Path
    log: Path
    environment: dict[str, str] = field(default_factory=lambda: {name: value for name, value in os.environ.items() if PASSED_ON.match(name)})

    def make(self, keys: Path) -> str:
        """Makes the root folder from packages that are signed with ``keys``; empty, or why it cannot be made."""
        if not keys.exists():
            return f"the keys of its packages are not here: there is no {keys}"
        command = ["mmdebstrap", "--mode=root", "--variant=apt", f"--keyring={keys}", f"--components={self.release['components']}"]
        # A mirror that is a copy of some day has lists whose time is over; they are signed all the same.
        command += [
            '--aptopt=APT::Install-Recommends "false"',
            '--aptopt=Acquire::Check-Valid-Until "false"',
            f"--include={PREREQUISITES.replace(' ', ',')},sudo,passwd,mount",
        ]
        # Programs of another processor run in an emulator that the kernel starts (binfmt_misc); without it mmdebstrap says what to install.
        if architecture := self.release.get("architecture"):
            command.append(f"--arch={architecture}")
        command += [self.release["suite"], str(self.folder)]
        self.log.unlink(missing_ok=True)
        if self._logged(command) != 0:
            self.remove()
            return first_error(self.log.read_text(errors="replace")) or f"mmdebstrap failed; its log is {self.log}"
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
        return ""

    def run(self, script: str, user: str = "root", output: Path | None = None, network: bool = True) -> int:
        """
        Run a shell script in the system, with a /proc of its own; nothing that it starts stays.

        The output goes to the log, and to ``output`` when one is given. Without ``network`` there is not even this machine's own address.
        """
        exports = "".join(f"export {name}={shlex.quote(value)}; " for name, value in self.environment.items())
        inner = f"{exports}cd; {script}"
        folder = shlex.quote(str(self.folder))
        mounts = "mount -t proc proc proc; mount --rbind /dev dev; mount -t tmpfs tmpfs tmp"
        # Not only chroot: the kernel gives no user namespace, and so no sandbox, to a user in a changed root.
        pivot = "pivot_root . . && umount -l ."
        enter = f"mount --bind {folder} {folder}; cd {folder}; {mounts}; {pivot} && exec chroot . su - {user} -c {shlex.quote(inner)}"
        command = ["unshare", *([] if network else ["--net"]), "--mount", "--pid", "--fork", "--kill-child", "bash", "-c", enter]
        return self._logged(command, output)

    def text(self, script: str, user: str = "root", network: bool = True) -> str:
        """What a script prints."""
        output = self.folder / "output"
        self.run(script, user, output, network)
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
