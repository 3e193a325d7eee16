"""Answer that a request over HTTP cannot be served."""

from __future__ import annotations

import msgspec
from starlette.responses import JSONResponse, Response

from ...sentences.sentence import Sentence
from ...wire.problem import to_wire

__all__ = ["failure"]


def failure(said: Sentence, status: int) -> Response:
    """In English, and as a sentence for other languages."""
    content = {"message": str(said), "sentence": msgspec.to_builtins(to_wire(said))}
    return JSONResponse(content, status_code=status)
