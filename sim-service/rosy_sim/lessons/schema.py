"""The JSON schema of ``lesson.json``: ``python -m rosy_sim.lessons.schema`` writes ``protocol/lesson.schema.json``."""

from __future__ import annotations

import json
import sys
from typing import Any

import msgspec

from .lesson_file import LessonFile

__all__ = ["lesson_schema", "schema_text"]


def lesson_schema() -> dict[str, Any]:
    """The schema, as JSON Schema 2020-12."""
    schema = msgspec.json.schema(LessonFile)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Lesson",
        "description": "lesson.json of a folder in examples/lessons. SI units; degrees where a name says so.",
        **schema,
    }


def schema_text() -> str:
    """The text of the file."""
    return json.dumps(lesson_schema(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    sys.stdout.write(schema_text())
