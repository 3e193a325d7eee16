"""
Check of citations: every rule, document and protocol section that a source file cites exists.

In: the tracked files and their texts. Out: one sentence per citation that does not resolve. Citations have fixed forms: ``rule R7``,
``rules R1 to R5``, ``LANGUAGE.md``, ``protocol §4``. External documents (``Haskell 2010 report §4.4.2``) are not checked.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["citation_breaches"]

SOURCES = {".hs", ".py", ".ts", ".tsx", ".mjs", ".sh"}
"""Suffixes of files whose citations are checked; Markdown is checked for rules only, because its links name files of other repositories too."""

RULE = re.compile(r"\b[Rr]ules?\s+(R\d+(?:(?:,\s+|\s+and\s+|\s+to\s+)R\d+)*)")
UNNAMED_RULE = re.compile(r"\b[Rr]ules? \d+\b")
DOCUMENT = re.compile(r"(?<![\w*])((?:\.{0,2}/)?(?:[\w-]+/)*[A-Za-z][\w-]*\.md)\b")
FOLLOWED = {Path("ARCHITECTURE.md"), Path("CONTRIBUTING.md")}
"""Documents whose readers open the files they name, written from the root."""

FILE = re.compile(r"`((?:[\w.-]+/)+[\w.-]+\.\w+)`")
URL = re.compile(r"https?://\S+")
PROTOCOL_SECTION = re.compile(r"\bprotocol(?:/README\.md)?`?,? (?:§|section )(\d+)")


def rules_of(reference: str) -> set[str]:
    """The identifiers that LANGUAGE.md defines."""
    return set(re.findall(r'<a id="(R\d+)"></a>\1 ', reference))


def cited_rules(text: str) -> Iterator[str]:
    for match in RULE.finditer(text):
        yield from re.findall(r"R\d+", match.group(1))


def document_exists(name: str, path: Path, files: frozenset[Path], names: frozenset[str]) -> bool:
    """Relative to the citing file or to the root; a bare name may be anywhere."""
    if "/" not in name:
        return name in names
    tidy = name.removeprefix("./").removeprefix("/")
    return any(Path(*(base / tidy).parts) in files for base in [Path(), path.parent]) or any(f.as_posix().endswith("/" + tidy) for f in files)


def citation_breaches(root: Path, files: list[Path]) -> Iterator[str]:
    """One sentence per citation that does not resolve."""
    rules = rules_of((root / "rosy-hs/LANGUAGE.md").read_text())
    sections = set(re.findall(r"^## (\d+)\.", (root / "protocol/README.md").read_text(), re.M))
    everything = frozenset(files)
    names = frozenset(f.name for f in files)
    for path in files:
        is_source = path.suffix in SOURCES and not path.as_posix().startswith(("codegen/corpus/", "scripts/citations"))
        if not (is_source or path.suffix == ".md"):
            continue
        text = (root / path).read_text(errors="replace")
        if path in FOLLOWED:
            for name in FILE.findall(text):
                if Path(name) not in everything:
                    yield f"{path}: names {name}, which does not exist"
        for rule in sorted(set(cited_rules(text)) - rules):
            yield f"{path}: cites rule {rule}, which rosy-hs/LANGUAGE.md does not define"
        if not is_source:
            continue
        for old in UNNAMED_RULE.findall(text):
            yield f"{path}: cites “{old}”; cite a rule of rosy-hs/LANGUAGE.md as “rule R7”"
        for section in sorted(set(PROTOCOL_SECTION.findall(text)) - sections):
            yield f"{path}: cites protocol §{section}, which protocol/README.md does not have"
        for name in sorted(set(DOCUMENT.findall(URL.sub("", text)))):
            if not document_exists(name, path, everything, names):
                yield f"{path}: cites {name}, which is not in the repository"
