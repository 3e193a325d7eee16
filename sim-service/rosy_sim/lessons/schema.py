"""
The JSON schemas of lessons: ``python -m rosy_sim.lessons.schema`` writes ``protocol/lesson.schema.json``, of a folder's
``lesson.json``, and with ``document`` ``protocol/lesson-document.schema.json``, of a lesson as one JSON value.
"""

from __future__ import annotations

import json
import sys
from typing import Any

import msgspec

from .lesson_document import LessonDocument
from .lesson_file import LessonFile

__all__ = ["document_schema", "lesson_schema", "schema_text"]

_DIALECT = "https://json-schema.org/draft/2020-12/schema"


def lesson_schema() -> dict[str, Any]:
    """The schema of ``lesson.json``, as JSON Schema 2020-12."""
    return {
        "$schema": _DIALECT,
        "title": "Lesson",
        "description": "lesson.json of a folder in examples/lessons. SI units; degrees where a name says so.",
        **msgspec.json.schema(LessonFile),
    }


def document_schema() -> dict[str, Any]:
    """The schema of a lesson as one JSON value, as JSON Schema 2020-12."""
    return {
        "$schema": _DIALECT,
        "title": "Lesson document",
        "description": "A lesson as one file, as a page opens and writes it. SI units; degrees where a name says so.",
        **msgspec.json.schema(LessonDocument),
    }


def schema_text(schema: dict[str, Any]) -> str:
    """The text of the file."""
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    sys.stdout.write(schema_text(document_schema() if "document" in sys.argv[1:] else lesson_schema()))
