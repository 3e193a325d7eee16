"""
Distribution for Windows' WSL 2.4.4 and newer: a root file system as ``.wsl``, which a double click installs.

Its two files of settings and what they mean are described in Microsoft's "Build a custom Linux distribution for WSL" and "Advanced
settings configuration in WSL". WSL runs the first-start command as root before the first shell; each start of the Start-menu entry then
opens a shell of the default user, which starts Rosy and leaves a prompt when Rosy is ended by Ctrl-C.
"""

from __future__ import annotations

import gzip
import json
import math
import struct
import zlib
from pathlib import Path

from rosy_sim.version import VERSION

from .root_filesystem import HOME, PLACE, USER, USER_ID, ExtraFile, write_archive

__all__ = ["files", "icon", "make_wsl"]

_FOLDER = "usr/lib/wsl"

_DISTRIBUTION = f"""\
[oobe]
command = /{_FOLDER}/first-start
defaultUid = {USER_ID}
defaultName = Rosy

[shortcut]
enabled = true
icon = /{_FOLDER}/rosy.ico

[windowsterminal]
enabled = true
profileTemplate = /{_FOLDER}/terminal-profile.json
"""

# Rosy needs no service of the system, and starts sooner without systemd.
_SETTINGS = f"""\
[boot]
systemd = false

[user]
default = {USER}

[network]
hostname = rosy
"""

# A first start that fails would leave no shell at all, so it does nothing that can.
_FIRST_START = f"""\
#!/bin/sh
# WSL runs this as root, once, before the first shell.
install -d -o {USER} -g {USER} -m 755 /{HOME} || true
exit 0
"""

# Starts Rosy in the window that the Start menu opens; a second window shows the address. After Ctrl-C there is a prompt.
# A login shell reads it (bash(1), INVOCATION); `wsl COMMAND` has no terminal or is no login shell.
_PROFILE = f"""\
if [ "$(id -u)" = {USER_ID} ] && [ -t 0 ] && [ -t 1 ] && [ -z "${{ROSY_STARTED:-}}" ]; then
  export ROSY_STARTED=1
  if (exec 3<>/dev/tcp/127.0.0.1/8080) 2>/dev/null; then
    echo "http://localhost:8080"
  else
    rosy start --no-browser || true
  fi
fi
"""

_COLOUR = (0xD6, 0x17, 0x5A)
"""The page's own: red, green, blue (editor/index.html)."""


def files() -> list[ExtraFile]:
    """What a distribution has beside the system and Rosy."""
    return [
        ExtraFile("etc/wsl-distribution.conf", _DISTRIBUTION.encode()),
        ExtraFile("etc/wsl.conf", _SETTINGS.encode()),
        ExtraFile(_FOLDER, None, 0o755),
        ExtraFile(f"{_FOLDER}/first-start", _FIRST_START.encode(), 0o755),
        ExtraFile(f"{_FOLDER}/rosy.ico", icon()),
        ExtraFile(f"{_FOLDER}/terminal-profile.json", json.dumps({"profiles": [{"startingDirectory": "~"}]}).encode()),
        ExtraFile("etc/profile.d/rosy.sh", _PROFILE.encode()),
        ExtraFile("usr/bin/rosy", f'#!/bin/sh\nexec /{PLACE}/rosy "$@"\n'.encode(), 0o755),
    ]


def make_wsl(base: Path, tree: Path, output: Path, architecture: str, epoch: int) -> Path:
    """Write ``rosy-VERSION_ARCHITECTURE.wsl`` into the folder ``output``; returns its path."""
    target = output / f"rosy-{VERSION}_{architecture}.wsl"
    with target.open("wb") as opened, gzip.GzipFile("", "wb", 6, opened, mtime=epoch) as packed:
        write_archive(base, tree, files(), packed, epoch)
    return target


def icon(size: int = 64) -> bytes:
    """The page's icon as an ICO file with one PNG (W3C PNG 3; Windows reads PNG in it since Vista)."""
    rows = b""
    for y in range(size):
        rows += b"\0"
        for x in range(size):
            # In the units of the page's drawing, 26 to a side.
            across, down = (26 * (place + 0.5) / size for place in (x, y))
            away = math.hypot(across - 13, down - 13)
            is_drawn = abs(away - 11) <= (2.5 if down < 9 else 1.5) or math.hypot(across - 13, down - 15) <= 3
            rows += bytes((*_COLOUR, 255 * is_drawn))
    header = struct.pack(">IIBBBBB", size, size, 8, 6, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, data) for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")))
    return struct.pack("<HHHBBBBHHII", 0, 1, 1, size, size, 0, 0, 1, 32, len(png), 22) + png


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
