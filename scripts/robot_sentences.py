"""
Translations for executables that run without Rosy: the sentences of `rosy-hs/robots`, `rosy-hs/app` and `rosy-hs/src` in every language.

In: their templates, and the tables `languages/*/sentences.json`. Out: `rosy-hs/robots/generated/Rosy/Robots/Translations.hs`, which
`python3 scripts/robot_sentences.py` writes and `borders.py` compares. Each table is JSON text, which `Rosy.Robots.Wording` reads when it is needed.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from sentences import FORMS, ROOT, TABLES, haskell_ids

FOLDERS = ("rosy-hs/robots", "rosy-hs/app", "rosy-hs/src")
MODULE = Path("rosy-hs/robots/generated/Rosy/Robots/Translations.hs")

_HEADER = """-- |
-- Module      : Rosy.Robots.Translations
-- Description : Tables of sentences in other languages, made by scripts/robot_sentences.py from languages/*/sentences.json.
module Rosy.Robots.Translations
  ( tables,
  )
where

-- | The tag of a language, and its table as JSON.
tables :: [(String, String)]
tables =
"""


def module_text(root: Path = ROOT) -> str:
    """The text of the generated module."""
    ids = haskell_ids(root, FOLDERS)
    written = [_table(path.parent.name, json.loads(path.read_text()), ids) for path in sorted(root.glob(TABLES))]
    return _HEADER + "  [ " + ",\n    ".join(written) + "\n  ]\n"


def _table(tag: str, table: dict[str, object], ids: set[str]) -> str:
    said = table["sentences"]
    assert isinstance(said, dict)
    wanted = {**{form: table[form] for form in FORMS}, "sentences": {known: said[known] for known in sorted(ids) if known in said}}
    # ASCII: JSON writes other letters as \\uXXXX. Each line is a literal, so that a difference is one sentence.
    lines = json.dumps(wanted, indent=0, ensure_ascii=True).split("\n")
    literals = ",\n          ".join('"' + line.replace("\\", "\\\\").replace('"', '\\"') + '"' for line in lines)
    return f'( "{tag}",\n      concat\n        [ {literals}\n        ]\n    )'


def translation_breaches(root: Path = ROOT) -> Iterator[str]:
    """Whether the module was made of the tables as they are."""
    if (root / MODULE).read_text() != module_text(root):
        yield f"{MODULE.as_posix()}: is not made of the tables as they are; python3 scripts/robot_sentences.py writes it"


if __name__ == "__main__":
    (ROOT / MODULE).write_text(module_text())
