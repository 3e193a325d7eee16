"""
Sentences in the reader's language: a template and its arguments become a text, with ``languages/<tag>/sentences.json``.

The page words what it shows itself (``editor/src/words/worker_sentences.ts``); this is for terminals and other editors.
English has no table. ``en-XA`` is English with accents, for tests: what still reads as English in it is no sentence of
a table.

Only the standard library is imported: ``./rosy estop`` works before anything is installed.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from .sentence import PLACEHOLDER, Argument, Template, english, fill

__all__ = [
    "ENGLISH",
    "LANGUAGES",
    "PSEUDO",
    "Wording",
    "in_terminal",
    "language_of",
    "machine_wording",
    "terminal_language",
    "wording",
]

PSEUDO = "en-XA"
"""English with accents, as Unicode's CLDR names the pseudo-locale."""

LANGUAGES = Path(__file__).resolve().parents[3] / "languages"
"""A folder for each language, named by its tag (languages/README.md)."""

_LOCALE_VARIABLES = ("ROSY_LOCALE", "LC_ALL", "LC_MESSAGES", "LANG")
"""
The first that is set and not empty names the language of messages. POSIX.1-2017, Base Definitions, section 8.2. The
first is what ``./rosy`` found where it had to choose another encoding.
"""

_PLAIN = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
_ACCENTS = str.maketrans(_PLAIN, "åƀçđéƒĝĥîĵķļɱñöþǫŕšţûṽŵẋýžÅƁÇĐÉƑĜĤÎĴĶĻṀÑÖÞǪŔŠŢÛṼŴẊÝŽ")
"""As in ``editor/src/words/pseudo_locales.ts``."""


@dataclass(frozen=True, slots=True)
class Forms:
    """What a table says besides its sentences; ``{type}`` stands in the first two. protocol/README.md, section 1.1."""

    type: str
    function: str
    # Before the last of a choice, and between types.
    alternative: str
    sequence: str
    # Words, from 0.
    numbers: Sequence[str]
    decimal_mark: str = ","


@dataclass(frozen=True, slots=True)
class Wording:
    """A language. ``template`` gives the translation of an English template, or ``None``."""

    language: str
    template: Callable[[str], str | None]
    forms: Forms | None

    def put(self, sentence: Template, otherwise: str | None = None) -> str:
        """The sentence in this language; ``otherwise``, or English, where the table lacks it."""
        forms = self.forms
        if not sentence.id or forms is None:
            return english(sentence) if otherwise is None else otherwise
        template = self.template(sentence.id)
        if template is None or any(name not in sentence.arguments for _, name in PLACEHOLDER.findall(template)):
            return english(sentence) if otherwise is None else otherwise
        return fill(template, sentence.arguments, lambda format, value: self._formatted(forms, format, value))

    def _formatted(self, forms: Forms, form: str, argument: Argument) -> str:
        if isinstance(argument, str):
            return _typed(forms, argument) if form == "a" else argument
        if isinstance(argument, int):
            return forms.numbers[argument] if form == "count" and 0 <= argument < len(forms.numbers) else str(argument)
        if isinstance(argument, float):
            return f"{argument:g}".replace(".", forms.decimal_mark)
        if isinstance(argument, Sequence):
            return _several(forms, form, argument)
        return self.put(argument)


def _typed(forms: Forms, name: str) -> str:
    """A type with its article."""
    return (forms.function if _is_function(name) else forms.type).replace("{type}", name)


def _is_function(name: str) -> bool:
    """Whether an arrow stands outside of all brackets."""
    while (inner := re.sub(r"\([^()]*\)|\[[^\[\]]*\]", "", name)) != name:
        name = inner
    return "->" in name


def _several(forms: Forms, form: str, names: Sequence[str]) -> str:
    if form == "then":
        return forms.sequence.join(_typed(forms, name) for name in names)
    if form != "or":
        return ", ".join(names)
    quoted = [f"‘{name}’" for name in names]
    return forms.alternative.join([", ".join(quoted[:-1]), quoted[-1]]) if len(quoted) > 1 else "".join(quoted)


ENGLISH = Wording("en", lambda _: None, None)


@cache
def wording(language: str) -> Wording:
    """The language of a table, the pseudo-language, or else English."""
    if language == PSEUDO:
        return Wording(PSEUDO, _with_accents, Forms("å ‘{type}’", "å ƒûñçţîöñ ‘{type}’", " öŕ ", ", ţĥéñ ", (), "."))
    table = LANGUAGES / language / "sentences.json"
    if re.fullmatch(r"[a-z]{2,3}", language) is None or not table.is_file():
        return ENGLISH
    read = json.loads(table.read_text("utf-8"))
    sentences: Mapping[str, str] = read.pop("sentences")
    return Wording(language, sentences.get, Forms(**read))


def _with_accents(template: str) -> str:
    said, end = "", 0
    for found in PLACEHOLDER.finditer(template):
        said += template[end : found.start()].translate(_ACCENTS) + found[0]
        end = found.end()
    return said + template[end:].translate(_ACCENTS)


def language_of(tag: str) -> str:
    """The language of a locale as POSIX or an editor names it: ``pt_BR.UTF-8`` and ``pt-BR`` are ``pt``."""
    name = re.split(r"[.@]", tag.replace("_", "-"))[0]
    return PSEUDO if name.lower() == PSEUDO.lower() else name.partition("-")[0].lower()


def terminal_language(environment: Mapping[str, str]) -> str:
    """The language that the variables of the locale name; English for ``C`` and ``POSIX``, and when none is set."""
    named = next((environment[name] for name in _LOCALE_VARIABLES if environment.get(name)), "")
    language = language_of(named)
    return "en" if language in ("", "c", "posix") else language


def machine_wording() -> Wording:
    """The language of this machine's terminals."""
    return wording(terminal_language(os.environ))


def in_terminal(sentence: Template, otherwise: str | None = None) -> str:
    """The sentence in the language of this machine's terminals."""
    return machine_wording().put(sentence, otherwise)
