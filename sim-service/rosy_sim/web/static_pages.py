"""
Static pages: serves built files compressed and with cache headers.

Thirty pages that open at once share one network. A file with its gzip beside it (`scripts/lib/setup.sh` makes it) is
sent compressed. A file under `assets/`, whose name contains a hash of its content, is cached for good. Other files are
revalidated each time.
"""

from __future__ import annotations

import os
import re

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

__all__ = ["StaticPages"]

_CACHE_FOR_GOOD = "public, max-age=31536000, immutable"
"""One year, the longest that HTTP recommends. RFC 9111, section 1.2.2; RFC 8246."""

_REVALIDATE = "no-cache"

_ZERO_WEIGHT = re.compile(r"q=0(\.0*)?")
"""The weight of a coding that must not be sent."""


class StaticPages(StaticFiles):
    """A folder of built pages."""

    def file_response(
        self, full_path: str | os.PathLike[str], stat_result: os.stat_result, scope: Scope, status_code: int = 200
    ) -> Response:
        """The file, or its compressed version for clients that accept it."""
        compressed = f"{os.fspath(full_path)}.gz"
        packed = _stat(compressed)
        # A compressed file that is older than the file belongs to an earlier version.
        has_compressed = packed is not None and packed.st_mtime_ns >= stat_result.st_mtime_ns
        if packed is not None and has_compressed and _takes_gzip(scope):
            response = super().file_response(compressed, packed, scope, status_code)
            response.headers["Content-Encoding"] = "gzip"
        else:
            response = super().file_response(full_path, stat_result, scope, status_code)
        if has_compressed:
            response.headers["Vary"] = "Accept-Encoding"
        lasting = os.path.basename(os.path.dirname(full_path)) == "assets"
        response.headers["Cache-Control"] = _CACHE_FOR_GOOD if lasting else _REVALIDATE
        return response


def _takes_gzip(scope: Scope) -> bool:
    """Whether gzip is named, and with another weight than none. RFC 9110, section 12.5.3."""
    for named in Headers(scope=scope).get("accept-encoding", "").lower().split(","):
        coding, *options = (part.replace(" ", "").replace("\t", "") for part in named.split(";"))
        if coding == "gzip":
            return not any(_ZERO_WEIGHT.fullmatch(option) for option in options)
    return False


def _stat(path: str) -> os.stat_result | None:
    try:
        return os.stat(path)
    except OSError:
        return None
