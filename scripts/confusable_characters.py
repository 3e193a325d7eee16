"""
The page's tables of characters that look like those of Haskell, made of the worker's.

In: `rosy-hs/worker/Rosy/Worker/Explanation/ConfusableCharacters.hs`. Out: `codegen/src/source/confusable_tables.generated.ts`, which
`python3 scripts/confusable_characters.py` writes and `borders.py` compares.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

from sentences import ROOT

SOURCE = Path("rosy-hs/worker/Rosy/Worker/Explanation/ConfusableCharacters.hs")
MODULE = Path("codegen/src/source/confusable_tables.generated.ts")

_HEADER = """/// Characters that look like those of Haskell, made by scripts/confusable_characters.py from ConfusableCharacters.hs of the worker.
/// Names are sentences of languages/<tag>/sentences.json.

"""


def module_text(root: Path = ROOT) -> str:
    """The text of the generated module."""
    source = (root / SOURCE).read_text()
    signs = re.findall(r"""\('(.)', \("((?:\\.|[^"])*)", tr "([^"]*)"\)\)""", source)
    unseen = re.findall(r"""\('\\x([0-9A-F]+)', tr "([^"]*)"\)""", source)
    zipped = re.findall(r'zip "([^"]*)" "([^"]*)"', source)
    letters = [pair for odd, plain in zipped for pair in zip(odd, plain, strict=True)]
    assert signs, "the signs of the worker are written in another way"
    assert unseen, "the unseen characters of the worker are written in another way"
    assert letters, "the letters of the worker are written in another way"
    plain_signs = [(odd, [plain.replace("\\", ""), name]) for odd, plain, name in signs]
    return _HEADER + "\n".join(
        [
            _table("What is written for a sign, and the sign's name.", "confusableSigns", "readonly [plain: string, name: string]", plain_signs),
            _table("Letters that look Latin.", "confusableLetters", "string", letters),
            _table("Characters that cannot be seen, and their names.", "unseenCharacters", "string", [(chr(int(code, 16)), name) for code, name in unseen]),
        ]
    )


def _table(says: str, name: str, value: str, rows: list[tuple[str, object]]) -> str:
    # Those that cannot be seen are written by their numbers.
    lines = [f"  [{json.dumps(key, ensure_ascii=not key.isprintable())}, {json.dumps(of, ensure_ascii=False)}]," for key, of in rows]
    return f"/// {says}\nexport const {name}: ReadonlyMap<string, {value}> = new Map([\n" + "\n".join(lines) + "\n])\n"


def confusable_breaches(root: Path = ROOT) -> Iterator[str]:
    """Whether the page's tables were made of the worker's as they are."""
    if (root / MODULE).read_text() != module_text(root):
        yield f"{MODULE.as_posix()}: is not made of the worker's tables as they are; python3 scripts/confusable_characters.py writes it"


if __name__ == "__main__":
    (ROOT / MODULE).write_text(module_text())
