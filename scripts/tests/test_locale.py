"""The language of `./rosy` itself: before anything is installed it follows the machine's locale."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from shell_sentences import shell_bypasses, shell_templates

from .sandbox import ROOT, Machine, machine

LANGUAGES = sorted(table.parent.name for table in ROOT.glob("languages/*/sentences.json"))

# Three English words that follow one another, outside of commands and paths.
_ENGLISH = re.compile(r"(?<![\w/-])[A-Za-z']{2,} [a-z]{2,} [a-z]{2,}(?![\w/-])")


@pytest.fixture
def bare(tmp_path: Path) -> Machine:
    """A machine on which everything is missing."""
    made = machine(tmp_path)
    made.tool("dpkg-query", "exit 1")
    made.tool("python3", "exit 1")
    made.tool("ghc", "echo 8.8.4")
    made.tool("curl", "exit 6")
    made.tool("df", 'echo; echo "x 1 1 10 99% /"')
    made.tool("uname", "echo Plan9")
    return made


@pytest.mark.parametrize("language", ["en", *LANGUAGES])
def test_each_help_page_is_in_the_language_of_the_locale(tmp_path: Path, language: str) -> None:
    pages = ROOT / "languages" / language / "help"
    here = machine(tmp_path)
    env = {"LC_ALL": f"{language}_XX.UTF-8"}
    assert here.rosy("help", env=env).stdout == (pages / "commands.txt").read_text()
    for page in pages.glob("*.txt"):
        if page.stem != "commands":
            assert here.rosy(page.stem, "--help", env=env).stdout == page.read_text()


def test_a_language_without_pages_shows_the_english_ones(tmp_path: Path) -> None:
    here = machine(tmp_path)
    assert here.rosy("help", env={"LC_ALL": "xx_XX.UTF-8"}).stdout == (ROOT / "languages/en/help/commands.txt").read_text()


def test_an_unknown_command_is_refused_in_german(tmp_path: Path) -> None:
    done = machine(tmp_path).rosy("frobnicate", env={"LC_ALL": "de_DE.UTF-8"})
    # Bash itself may warn first, of a locale that is not installed.
    assert done.returncode == 1
    assert done.stderr.endswith("rosy: Es gibt keinen Befehl „frobnicate“. ./rosy help zählt alle auf.\n")


@pytest.mark.parametrize(("variable", "value"), [("LANG", "fr_FR.UTF-8"), ("LC_MESSAGES", "fr_CA"), ("ROSY_LOCALE", "fr")])
def test_the_variables_of_the_locale_name_the_language(tmp_path: Path, variable: str, value: str) -> None:
    done = machine(tmp_path).rosy("frobnicate", env={"LC_ALL": "", variable: value})
    assert "il n’y a pas de commande" in done.stderr


def test_nothing_that_set_up_says_bypasses_the_tables(bare: Machine) -> None:
    refused = bare.rosy("start", env={"ROSY_LOCALE": "en_XA"})
    assert refused.returncode == 1
    assert "Þýţĥöñ 3.11" in refused.stderr
    assert _english(refused.stderr) == []


def test_no_step_says_anything_that_bypasses_the_tables(tmp_path: Path) -> None:
    here = machine(tmp_path)
    here.tool("cabal", "exit 1")
    failed = here.rosy("start", env={"ROSY_LOCALE": "en_XA"})
    assert failed.returncode == 1
    assert ".rosy/log/haskell.log" in failed.stderr
    assert _english(failed.stderr) == []


def _english(text: str) -> list[str]:
    # Commands that the reader types are the same in every language.
    return _ENGLISH.findall(re.sub(r"(?:sudo )?apt-get [^\n;]*|libghc-\S+", "", text))


def test_templates_of_a_script_are_read_with_their_arguments() -> None:
    source = """
# say "in a comment"
say() { printf; }
say "One {n}." n "$(date -u)"
x || give_up "Two {a}, {b}." \\
  a "$x" b 3
say "$ready"
lacks "$(sentence "Three.")" "$(sentence "{command}; or four" command "$(root_prefix)apt-get clean")"
"""
    assert list(shell_templates(source)) == [
        (4, "One {n}.", {"n"}),
        (5, "Two {a}, {b}.", {"a", "b"}),
        (7, None, None),
        (8, "Three.", set()),
        (8, "{command}; or four", {"command"}),
    ]


def test_english_beside_the_calls_is_found() -> None:
    assert list(shell_bypasses('say "A sentence of four words."\nlacks "This is no call." x')) == [(2, "This is no call.")]
