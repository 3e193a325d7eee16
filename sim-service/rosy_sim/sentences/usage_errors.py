"""Sentences of argparse, which reports wrong options in English only, as sentences of our tables."""

from __future__ import annotations

import re

from .sentence import Sentence, tr, verbatim

__all__ = ["usage_error"]


def usage_error(message: str) -> Sentence:
    """The sentence for a message of argparse (Python 3.11 to 3.14); an unknown one stays as it is."""
    if found := re.fullmatch(r"the following arguments are required: (.*)", message):
        return tr("the following arguments are required: {names}", names=found[1])
    found = re.fullmatch(r"argument ([^:]*): (.*)", message, re.DOTALL)
    if found is None:
        return verbatim(message)
    return tr("argument {name}: {why}", name=found[1], why=_about_argument(found[2]))


def _about_argument(why: str) -> Sentence:
    match why:
        case "expected one argument":
            return tr("expected one argument")
        case "expected at least one argument":
            return tr("expected at least one argument")
        case "expected at most one argument":
            return tr("expected at most one argument")
    if found := re.fullmatch(r"invalid int value: (.*)", why, re.DOTALL):
        return tr("invalid int value: {value}", value=found[1])
    if found := re.fullmatch(r"invalid float value: (.*)", why, re.DOTALL):
        return tr("invalid float value: {value}", value=found[1])
    if found := re.fullmatch(r"invalid choice: (.*) \(choose from (.*)\)", why, re.DOTALL):
        return tr("invalid choice: {value} (choose from {names})", value=found[1], names=found[2])
    if found := re.fullmatch(r"ignored explicit argument (.*)", why, re.DOTALL):
        return tr("ignored explicit argument {value}", value=found[1])
    return verbatim(why)
