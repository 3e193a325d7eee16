"""rosy-robot follows the locale of the machine; the pseudo-language shows that no sentence of it is in English only."""

from __future__ import annotations

import os
import re
import subprocess

import pytest

from rosy_sim.config import discover

pytestmark = pytest.mark.real

_ENGLISH = re.compile(r"(?<![\w/:-])[A-Za-z']{2,} [a-z]{2,} [a-z]{2,}(?![\w/:-])")
"""Three English words that follow one another."""


def said(locale: str, *arguments: str) -> str:
    """What rosy-robot says about arguments that it refuses."""
    executable = discover().robot_executable
    assert executable is not None, "rosy-robot is not built"
    environment = {
        name: value for name, value in os.environ.items() if name not in ("ROSY_LOCALE", "LC_MESSAGES", "LANG")
    }
    done = subprocess.run(
        [str(executable), *arguments],
        env={**environment, "LC_ALL": locale},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    return done.stderr


@pytest.mark.parametrize(
    ("locale", "sentence"),
    [
        ("C.UTF-8", 'A robot has no option "colour".'),
        ("de_DE.UTF-8", "Ein Roboter hat keine Option „colour“."),
        ("es", "Un robot no tiene la opción «colour»."),
        ("fr_CA.UTF-8", "Un robot n’a pas d’option «\u202fcolour\u202f»."),
        ("pt_BR", "Um robô não tem a opção “colour”."),
    ],
)
def test_an_address_is_refused_in_the_language_of_the_locale(locale: str, sentence: str) -> None:
    assert sentence in said(locale, "check", "ws://pi?colour=red")


@pytest.mark.parametrize(
    "arguments",
    [(), ("check", "pi"), ("check", "ws://pi?robot=hal"), ("check", "ws://pi?ros=7"), ("ws://pi", "seven")],
    ids=" ".join,
)
def test_no_refusal_is_in_english_only(arguments: tuple[str, ...]) -> None:
    found = said("en_XA", *arguments)
    assert found.strip()
    assert _ENGLISH.search(found) is None
