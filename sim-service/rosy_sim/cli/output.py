"""Output of a command: results on standard output, problems on standard error, without orders to the terminal."""

from __future__ import annotations

import sys
from pathlib import Path

from ..errors import OutputFailed, RosyError
from ..sentences.sentence import Sentence
from ..sentences.terminal_text import neutralize, neutralize_line
from ..sentences.wording import in_terminal
from ..wire.problem import Problem
from .problem_text import format_problem

__all__ = [
    "flush_output",
    "print_bytes",
    "print_error",
    "print_note",
    "print_problem",
    "print_sentence",
    "print_text",
    "say",
]


def print_text(text: str) -> None:
    try:
        print(text)
    except OSError as error:
        raise OutputFailed(error) from error


def print_bytes(data: bytes) -> None:
    """What is for a file or another program."""
    try:
        sys.stdout.buffer.write(data)
    except OSError as error:
        raise OutputFailed(error) from error


def say(text: str) -> None:
    print_text(neutralize(text))
    flush_output()


def print_sentence(sentence: Sentence) -> None:
    print_text(neutralize_line(in_terminal(sentence)))


def flush_output() -> None:
    try:
        sys.stdout.flush()
    except OSError as error:
        raise OutputFailed(error) from error


def print_error(error: RosyError) -> None:
    print_note(error.sentence)


def print_note(sentence: Sentence) -> None:
    print(f"rosy: {neutralize_line(in_terminal(sentence))}", file=sys.stderr)


def print_problem(file: Path, found: Problem) -> None:
    print(format_problem(file, found, sys.stderr.isatty()), file=sys.stderr)
