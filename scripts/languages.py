"""
Languages of Rosy: the registry `languages/languages.json`, and which parts a language has to have.

In: the folders in `languages`. Out: the registered tags, and one sentence per part that is missing. What the parts hold is checked where they
are used: `sentences.py` (sentences and help pages), `robot_typescript.py` (labels of robots), the TypeScript compiler (words of page and blocks).
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LANGUAGES = Path("languages")

PARTS = {
    "blocks/index.ts": "words on blocks",
    "page/index.ts": "words of the page",
    "help/commands.txt": "help pages of the commands",
    "pupil_words.txt": "words that pupils get",
    "sentences.json": "sentences of the service and the worker; python3 scripts/sentences.py prints a table to fill",
}
"""Files of a language, and what they hold. English has no `sentences.json`: its sentences stand where they are made."""


def languages(root: Path = ROOT) -> list[str]:
    """Tags of the registered languages, in the order of the page's menu."""
    return list(json.loads((root / LANGUAGES / "languages.json").read_text()))


def language_breaches(root: Path = ROOT) -> Iterator[str]:
    """Languages without a line in the registry or without a part, each as a sentence."""
    registered = languages(root)
    for folder in sorted(path.name for path in (root / LANGUAGES).iterdir() if path.is_dir()):
        if folder not in registered:
            yield f"languages/{folder}: has no line in languages/languages.json, and the page does not offer it"
    for tag in registered:
        for part, what in PARTS.items():
            if not (root / LANGUAGES / tag / part).is_file() and (tag, part) != ("en", "sentences.json"):
                yield f"languages/{tag}/{part}: is missing: {what}"
