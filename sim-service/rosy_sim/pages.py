"""
Serves what was built: as small as the browser takes it, and only once.

Thirty pages that open at once share one network. So a file with its gzip beside it (`scripts/lib/setup.sh`
makes it) goes out compressed, and a file under `assets/`, whose name says what is in it, is never asked for
again. The rest is asked for each time, and sent only when it has changed.
"""

from __future__ import annotations

import os
import re

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

__all__ = ["Pages"]

_FOREVER = "public, max-age=31536000, immutable"
"""A year is what HTTP calls forever. RFC 9111, section 1.2.2; RFC 8246."""

_ASK_FIRST = "no-cache"

_NO_WEIGHT = re.compile(r"q=0(\.0*)?")
"""Of a coding that is not to be sent."""


class Pages(StaticFiles):
    """A folder of built pages."""

    def file_response(
        self, full_path: str | os.PathLike[str], stat_result: os.stat_result, scope: Scope, status_code: int = 200
    ) -> Response:
        """The file, or its compressed twin for whoever takes that."""
        twin = f"{os.fspath(full_path)}.gz"
        packed = _stat(twin)
        # A twin that is older than its file belongs to what the file was before.
        has_twin = packed is not None and packed.st_mtime_ns >= stat_result.st_mtime_ns
        if packed is not None and has_twin and _takes_gzip(scope):
            response = super().file_response(twin, packed, scope, status_code)
            response.headers["Content-Encoding"] = "gzip"
        else:
            response = super().file_response(full_path, stat_result, scope, status_code)
        if has_twin:
            response.headers["Vary"] = "Accept-Encoding"
        lasting = os.path.basename(os.path.dirname(full_path)) == "assets"
        response.headers["Cache-Control"] = _FOREVER if lasting else _ASK_FIRST
        return response


def _takes_gzip(scope: Scope) -> bool:
    """Whether gzip is named, and with another weight than none. RFC 9110, section 12.5.3."""
    for named in Headers(scope=scope).get("accept-encoding", "").lower().split(","):
        coding, *options = (part.replace(" ", "").replace("\t", "") for part in named.split(";"))
        if coding == "gzip":
            return not any(_NO_WEIGHT.fullmatch(option) for option in options)
    return False


def _stat(path: str) -> os.stat_result | None:
    try:
        return os.stat(path)
    except OSError:
        return None
