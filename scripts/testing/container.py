"""
Container of an image without an engine: unpacks what `./rosy package image` wrote and starts it by crun or runc.

The container has what the documents ask for and no more: an ordinary user without capabilities, a root that cannot be written, one volume,
the seccomp profile beside the image, and, when ``is_masked`` is false, a /proc that the engine has not covered. Its network has nothing but its own address.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tarfile
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

__all__ = ["Container", "runtime"]

MASKED = ["/proc/kcore", "/proc/keys", "/proc/timer_list", "/proc/scsi"]
"""Some of what engines cover; one is enough for the kernel to refuse a new /proc inside (mount_too_revealing in fs/namespace.c)."""


def runtime() -> str | None:
    """The program that starts containers, if there is one."""
    return next((found for name in ("runc", "crun") if (found := shutil.which(name, path="/usr/bin:/usr/sbin:/bin:/sbin"))), None)


@dataclass
class Container:
    """An image that is unpacked into a folder, which must not exist."""

    folder: Path
    seccomp: dict[str, Any]
    config: dict[str, Any]

    @classmethod
    def unpack(cls, image: Path, seccomp: Path, folder: Path) -> Container:
        (folder / "rootfs").mkdir(parents=True)
        with tempfile.TemporaryDirectory(dir=folder) as work:
            # In tarfile's own filter for archives that are trusted: owners and modes stay.
            with tarfile.open(image) as archive:
                archive.extractall(work, filter="fully_trusted")
            (manifest,) = json.loads(Path(work, "manifest.json").read_text())
            config = json.loads(Path(work, manifest["Config"]).read_text())["config"]
            for layer in manifest["Layers"]:
                with tarfile.open(Path(work, layer)) as archive:
                    archive.extractall(folder / "rootfs", filter="fully_trusted", numeric_owner=True)
        volume = folder / "volume"
        volume.mkdir(mode=0o700)
        user, group = (int(number) for number in config["User"].split(":"))
        shutil.chown(volume, user, group)
        return cls(folder, json.loads(seccomp.read_text()), config)

    def command(self, arguments: list[str], is_masked: bool = False) -> list[str]:
        """What starts the image with these arguments in place of its own."""
        (self.folder / "config.json").write_text(json.dumps(self._bundle(arguments, is_masked)))
        return [*self._runtime(), "run", "--bundle", str(self.folder), self.name]

    def run(self, arguments: list[str], is_masked: bool = False, seconds: int = 300) -> subprocess.CompletedProcess[str]:
        return subprocess.run(self.command(arguments, is_masked), capture_output=True, text=True, timeout=seconds, check=False, stdin=subprocess.DEVNULL)

    @property
    def name(self) -> str:
        return f"rosy-{self.folder.name}"

    def inside(self, arguments: list[str]) -> int:
        """The exit status of a program in the container that runs."""
        return subprocess.run([*self._runtime(), "exec", self.name, *arguments], stdin=subprocess.DEVNULL, check=False).returncode

    def end(self) -> None:
        subprocess.run([*self._runtime(), "kill", self.name, "TERM"], check=False, capture_output=True)

    def _runtime(self) -> list[str]:
        started = runtime()
        assert started is not None
        return [started, "--root", str(self.folder / "state")]

    def _bundle(self, arguments: list[str], is_masked: bool) -> dict[str, Any]:
        """OCI Runtime Specification, "Configuration"."""
        user, group = (int(number) for number in self.config["User"].split(":"))
        (volume,) = self.config["Volumes"]
        nothing: list[str] = []
        capabilities = dict.fromkeys(("bounding", "effective", "permitted", "inheritable", "ambient"), nothing)
        return {
            "ociVersion": "1.0.2",
            "process": {
                "terminal": False,
                "user": {"uid": user, "gid": group},
                "args": [*self.config["Entrypoint"], *arguments],
                "env": self.config["Env"],
                "cwd": self.config["WorkingDir"],
                "capabilities": capabilities,
                "noNewPrivileges": True,
            },
            "root": {"path": "rootfs", "readonly": True},
            "mounts": [
                {"destination": "/proc", "type": "proc", "source": "proc"},
                {"destination": "/dev", "type": "tmpfs", "source": "tmpfs", "options": ["nosuid", "mode=755", "size=65536k"]},
                {"destination": "/dev/pts", "type": "devpts", "source": "devpts", "options": ["nosuid", "noexec", "newinstance", "ptmxmode=0666"]},
                {"destination": "/dev/shm", "type": "tmpfs", "source": "shm", "options": ["nosuid", "nodev", "noexec", "mode=1777"]},
                {"destination": volume, "type": "bind", "source": str(self.folder / "volume"), "options": ["rbind", "rw"]},
            ],
            "linux": {
                "namespaces": [{"type": kind} for kind in ("pid", "ipc", "uts", "mount", "network")],
                "seccomp": self.seccomp,
                "maskedPaths": MASKED if is_masked else [],
                "readonlyPaths": ["/proc/sys", "/proc/sysrq-trigger"] if is_masked else [],
            },
        }
