"""
Translatable sentences: an English template with named arguments, and its text in English.

The template is the id of a sentence, as in gettext: English stands where the sentence is made, other languages in
``languages/<tag>/sentences.json`` (protocol/README.md, section 1.1). ``scripts/sentences.py`` reads the templates
from the calls of ``tr``, which is why they are literals there.

Only the standard library is imported: ``./rosy estop`` works before anything is installed.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

__all__ = [
    "PLACEHOLDER",
    "Argument",
    "Sentence",
    "SentenceError",
    "Template",
    "english",
    "fill",
    "sentence_of",
    "template",
    "tr",
    "verbatim",
]

PLACEHOLDER = re.compile(r"\{(?:([A-Za-z]+) )?([A-Za-z]+)\}")
"""``{name}`` or ``{format name}``."""


class Template(Protocol):
    """A sentence of this service, or one that the worker sent."""

    @property
    def id(self) -> str:
        """The English template; empty for a text without translation, which is the argument ``text``."""
        ...

    @property
    def arguments(self) -> Mapping[str, Argument]:
        """The values of the placeholders."""
        ...


Argument = str | int | float | Sequence[str] | Template
"""A float is formatted with the decimal mark of the language; a number that has to be typed as shown is a string."""


@dataclass(frozen=True, slots=True)
class Sentence:
    """Made by ``tr`` or ``verbatim``. ``str`` gives the English text."""

    id: str
    arguments: Mapping[str, Argument]

    def __str__(self) -> str:
        return english(self)


def tr(template: str, /, **arguments: Argument | os.PathLike[str] | BaseException) -> Sentence:
    """
    A sentence with a value for each placeholder.

    An exception stands for its own sentence, or its text when it has none.
    """
    return Sentence(template, {name: _argument(value) for name, value in arguments.items()})


def template(text: str) -> str:
    """A template in a table: attributes of one value are its arguments. ``scripts/sentences.py`` reads these calls."""
    return text


def verbatim(text: str) -> Sentence:
    """A text that has no translation: the words of another program, or of the system."""
    return Sentence("", {"text": text})


class SentenceError(Exception):
    """A failure that a sentence explains; ``str`` gives the English text."""

    def __init__(self, sentence: Sentence) -> None:
        super().__init__(str(sentence))
        self.sentence = sentence


def sentence_of(error: BaseException) -> Sentence:
    """What an exception says."""
    return error.sentence if isinstance(error, SentenceError) else verbatim(str(error))


def english(sentence: Template) -> str:
    """The text in English, as ``rosy-hs/src/Rosy/Sentence.hs`` makes it for those of programs and of the worker."""
    return fill(sentence.id or "{text}", sentence.arguments, _formatted)


def fill(template: str, arguments: Mapping[str, Argument], formatted: Callable[[str, Argument], str]) -> str:
    """The template with formatted arguments; a placeholder without an argument stays."""

    def one(found: re.Match[str]) -> str:
        argument = arguments.get(found[2])
        return found[0] if argument is None else formatted(found[1] or "", argument)

    return PLACEHOLDER.sub(one, template)


def _formatted(_format: str, argument: Argument) -> str:
    # The service's templates have no formats.
    if isinstance(argument, str):
        return argument
    if isinstance(argument, int):
        return str(argument)
    if isinstance(argument, float):
        return f"{argument:g}"
    if isinstance(argument, Sequence):
        return ", ".join(argument)
    return english(argument)


def _argument(value: Argument | os.PathLike[str] | BaseException) -> Argument:
    if isinstance(value, BaseException):
        return sentence_of(value)
    return os.fspath(value) if isinstance(value, os.PathLike) else value
