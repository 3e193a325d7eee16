"""
Container image for Docker, Podman and Kubernetes: one archive, made by buildah without a daemon and without rights of root.

The image starts as an ordinary user, writes to the volume ``/data`` only, and says by ``/api/health`` whether it serves. Its format is
Docker's, which all three read: that of OCI has no place for the health check. Beside it stands a seccomp profile with the system calls that
bubblewrap needs, which Docker's own profile refuses (docs/server.md says what else the sandbox needs).
"""

from __future__ import annotations

import gzip
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from rosy_sim.sentences.sentence import tr
from rosy_sim.version import VERSION

from .installed_tree import TreeError
from .root_filesystem import PLACE, USER_ID, ExtraFile, write_archive

__all__ = ["SECCOMP", "files", "make_image", "seccomp_profile"]

DATA, PORT = "/data", 8080

SECCOMP = "rosy-seccomp.json"

_HEALTH = f"""\
#!/bin/bash
# Exit status 0 when this Rosy answers that it serves.
exec 3<>/dev/tcp/127.0.0.1/{PORT} || exit 1
printf 'GET /api/health HTTP/1.0\\r\\nHost: localhost\\r\\n\\r\\n' >&3
read -r _ status _ <&3
[ "$status" = 200 ]
"""

_REFUSED = (
    # Modules, boot, swap and clocks of the machine.
    "acct", "clock_adjtime", "clock_settime", "adjtimex", "settimeofday", "stime", "create_module", "delete_module", "finit_module",
    "init_module", "kexec_file_load", "kexec_load", "reboot", "swapoff", "swapon", "nfsservctl", "quotactl", "quotactl_fd", "sysfs", "_sysctl",
    "uselib", "ustat", "vm86", "vm86old", "ioperm", "iopl", "get_kernel_syms", "query_module", "syslog", "lookup_dcookie", "fanotify_init",
    # Keys, which no namespace separates.
    "add_key", "keyctl", "request_key",
    # Large parts of the kernel that programs attack and Rosy does not use.
    "bpf", "perf_event_open", "userfaultfd", "io_uring_enter", "io_uring_register", "io_uring_setup", "ptrace", "process_vm_readv",
    "process_vm_writev", "kcmp", "open_by_handle_at", "name_to_handle_at", "personality", "move_pages", "mbind", "set_mempolicy",
    "migrate_pages", "fsopen", "fsconfig", "fsmount", "fspick", "move_mount", "open_tree", "mount_setattr", "setns", "vhangup",
)  # fmt: skip
"""System calls that neither Rosy nor bubblewrap makes, and that Docker's own profile refuses to a container without capabilities."""


def files() -> list[ExtraFile]:
    """What the image has beside the system and Rosy."""
    return [
        ExtraFile("usr/bin/rosy", f'#!/bin/sh\nexec /{PLACE}/rosy "$@"\n'.encode(), 0o755),
        ExtraFile("usr/bin/rosy-health", _HEALTH.encode(), 0o755),
        ExtraFile(DATA.lstrip("/"), None, 0o700, USER_ID),
    ]


def seccomp_profile() -> str:
    """In the format of Docker and Podman (docs.docker.com, "Seccomp security profiles for Docker")."""
    profile = {"defaultAction": "SCMP_ACT_ALLOW", "syscalls": [{"names": sorted(_REFUSED), "action": "SCMP_ACT_ERRNO", "errnoRet": 1}]}
    return json.dumps(profile, indent=2) + "\n"


def make_image(base: Path, tree: Path, output: Path, architecture: str, epoch: int) -> Path:
    """
    Write ``rosy-VERSION_ARCHITECTURE.image.tar.gz`` and the seccomp profile into the folder ``output``; returns the image's path.

    Raises:
        TreeError: buildah is missing or failed.
    """
    if shutil.which("buildah") is None:
        raise TreeError(tr("this system has no {name}: install it with {command}.", name="buildah", command="sudo apt install buildah uidmap"))
    target = output / f"rosy-{VERSION}_{architecture}.image.tar.gz"
    with tempfile.TemporaryDirectory(prefix="rosy-image-", dir=output) as work:
        # A storage of its own: nothing is left in that of the user.
        buildah = ["buildah", "--root", f"{work}/root", "--runroot", f"{work}/run", "--storage-driver", "vfs"]
        layer, archive, policy = Path(work, "layer.tar"), Path(work, "image.tar"), Path(work, "policy.json")
        # Whose images are taken (containers-policy.json(5)). None is fetched, and not every system has a policy.
        policy.write_text('{"default": [{"type": "insecureAcceptAnything"}]}')
        with layer.open("wb") as opened:
            write_archive(base, tree, files(), opened, epoch)
        try:
            container = _output(*buildah, "from", "--quiet", "scratch").strip()
            _output(*buildah, "add", "--quiet", container, str(layer), "/")
            layer.unlink()
            _output(*buildah, "config", *_settings(architecture), container)
            commit = ["commit", "--quiet", "--signature-policy", str(policy), "--format", "docker", "--timestamp", str(epoch)]
            _output(*buildah, *commit, container, f"docker-archive:{archive}:rosy:{VERSION}")
        finally:
            # Files of other users of the image belong to numbers that only buildah can remove.
            subprocess.run([*buildah, "rm", "--all"], capture_output=True, check=False)
            subprocess.run([*buildah, "rmi", "--all", "--force"], capture_output=True, check=False)
        with archive.open("rb") as written, target.open("wb") as opened, gzip.GzipFile("", "wb", 6, opened, mtime=epoch) as packed:
            shutil.copyfileobj(written, packed, 1 << 20)
    (output / SECCOMP).write_text(seccomp_profile())
    return target


def _settings(architecture: str) -> list[str]:
    """Options of ``buildah config``."""
    return [
        *("--arch", architecture, "--os", "linux"),
        *("--user", f"{USER_ID}:{USER_ID}", "--workingdir", DATA, "--volume", DATA, "--port", f"{PORT}/tcp"),
        *("--env", f"HOME={DATA}", "--env", f"XDG_DATA_HOME={DATA}", "--env", "LANG=C.UTF-8", "--env", "PATH=/usr/bin:/bin"),
        *("--entrypoint", '["/usr/bin/rosy"]', "--cmd", "start --host 0.0.0.0 --no-browser"),
        *("--healthcheck", "CMD /usr/bin/rosy-health", "--healthcheck-interval", "30s", "--healthcheck-start-period", "60s"),
        *("--label", "org.opencontainers.image.title=Rosy", "--label", f"org.opencontainers.image.version={VERSION}"),
        *("--label", "org.opencontainers.image.licenses=BSD-3-Clause"),
    ]


def _output(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise TreeError(tr("{command} failed: {why}", command=command[0], why=done.stderr.strip()))
    return done.stdout
