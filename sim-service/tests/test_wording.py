"""Sentences in the language of the machine: the choice of the language, arguments, and commands without English."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rosy_sim.cli.problem_text import format_problem
from rosy_sim.sentences.sentence import Sentence, tr, verbatim
from rosy_sim.sentences.wording import ENGLISH, PSEUDO, language_of, terminal_language, wording
from rosy_sim.wire.problem import Problem, problem, to_wire
from rosy_sim.worlds.gallery import world_names

from .test_cli import Here, environment, here

__all__ = ["environment", "here"]


@pytest.mark.parametrize(
    ("variables", "language"),
    [
        ({}, "en"),
        ({"LANG": "de_DE.UTF-8"}, "de"),
        ({"LANG": "de_DE.UTF-8", "LC_MESSAGES": "pt_BR"}, "pt"),
        ({"LANG": "de_DE.UTF-8", "LC_MESSAGES": "pt_BR", "LC_ALL": "C.UTF-8"}, "en"),
        ({"LANG": "fr_CA@euro", "LC_ALL": ""}, "fr"),
        ({"LANG": "POSIX"}, "en"),
        ({"LC_ALL": "en_XA.UTF-8"}, PSEUDO),
        ({"ROSY_LOCALE": "de_DE", "LC_ALL": "C.UTF-8"}, "de"),
    ],
)
def test_the_first_variable_that_is_set_names_the_language(variables: dict[str, str], language: str) -> None:
    assert terminal_language(variables) == language


def test_a_locale_of_an_editor_names_its_language() -> None:
    assert [language_of(tag) for tag in ("es", "es-MX", "PT-br", "en-xa")] == ["es", "es", "pt", PSEUDO]


@pytest.mark.parametrize("language", ["en", "nl", "../es", ""])
def test_a_language_without_a_table_is_english(language: str) -> None:
    assert wording(language) is ENGLISH


def test_arguments_are_put_as_the_language_does() -> None:
    spanish = wording("es")
    assert spanish.put(tr("There is no file {path}.", path="a.hs")) == "No existe el archivo a.hs."
    assert spanish.put(tr("(at {time} s)", time=2.5)) == "(a los 2,5 s)"
    wrong = tr("{where} is not a world: {why}", where=tr("This"), why=tr("the row is empty."))
    assert spanish.put(wrong) == "Esto no es una sala: la fila está vacía."
    # Formats of the worker's sentences.
    hole = Sentence("A task is needed here, but this is {a given}.", {"given": "Bumper -> Maybe Sound"})
    assert spanish.put(hole) == "Aquí se necesita una tarea, pero esto es una función ‘Bumper -> Maybe Sound’."


def test_what_a_table_lacks_stays_as_it_was() -> None:
    spanish = wording("es")
    assert spanish.put(Sentence("In no table: {n}.", {"n": 1})) == "In no table: 1."
    assert spanish.put(Sentence("In no table.", {}), "What the worker wrote.") == "What the worker wrote."
    assert spanish.put(Sentence("There is no file {path}.", {})) == "There is no file {path}."
    assert spanish.put(verbatim("exit code 2")) == "exit code 2"


def test_a_sentence_goes_over_the_wire_with_the_sentences_in_it() -> None:
    wired = to_wire(tr("at {path}: {why}", path="tiles", why=tr("the row is empty.")))
    assert wired is not None
    assert wording("de").put(wired) == "bei tiles: die Reihe ist leer."
    assert to_wire(verbatim("exit code 2")) is None


_FOUND = problem(
    "stuck", tr("The program stopped without saying why."), tr("Press Run once more."), time=2.5, ghc="panic!\n  line 2"
)


@pytest.mark.parametrize(
    ("locale", "line"),
    [
        ("C.UTF-8", "p.hs: The program stopped without saying why. Press Run once more. (at 2.5 s)"),
        ("de_DE.UTF-8", "p.hs: Das Programm hat aufgehört, ohne zu sagen, warum. Drück noch einmal Start. (bei 2,5 s)"),
        ("es_ES.UTF-8", "p.hs: El programa se paró sin decir por qué. Pulsa Ejecutar otra vez. (a los 2,5 s)"),
        ("pt_BR.UTF-8", "p.hs: O programa parou sem dizer por quê. Aperte Executar mais uma vez. (aos 2,5 s)"),
        (
            "fr_FR.UTF-8",
            "p.hs: Le programme s’est arrêté sans dire pourquoi. Appuie encore une fois sur Démarrer. (à 2,5 s)",
        ),
    ],
)
def test_a_problem_is_worded_for_the_terminal(locale: str, line: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", locale)
    assert format_problem(Path("p.hs"), _FOUND, with_compiler_text=False) == line


def test_a_person_at_a_terminal_sees_the_compilers_own_text(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
    plain = format_problem(Path("p.hs"), _FOUND, with_compiler_text=False)
    assert format_problem(Path("p.hs"), _FOUND, with_compiler_text=True) == f"{plain}\n    panic!\n      line 2"
    without = Problem(severity="error", kind="x", message="Wrong.", hint="", ghc="")
    assert format_problem(Path("p.hs"), without, with_compiler_text=True) == "p.hs: Wrong."


_ALL_PROPERTIES = "reaches-goal never-falls never-pushes 1 s returns-to-start covers 50 % room-goals"


@pytest.mark.parametrize(
    "command",
    [
        ["check"],
        ["check", "nowhere.hs"],
        ["check", "--nonsense", "nowhere.hs"],
        ["check", "."],
        ["check", "broken.rosy"],
        ["build", "nowhere.hs"],
        ["room", "p.hs"],
        ["replay", "p.hs", "p.hs", "--fit"],
        ["replay", "p.hs", "-o", "room.json"],
        ["nonsense"],
        ["run", "p.hs", "--seconds", "many"],
        ["run", "p.hs", "--seconds", "-1"],
        ["run", "p.hs", "--seconds"],
        ["run", "p.hs", "--speed", "0"],
        ["run", "p.hs", "--safety", "perhaps"],
        ["run", "p.hs", "--world", "nowhere"],
        ["run", "p.hs", "--world", "flat.json"],
        ["run", "p.hs", "--family", "maze"],
        ["run", "p.hs", "--rooms", "0"],
        ["run", "p.hs", "--rooms", "2", "--world", "room"],
        ["run", "p.hs", "--rooms", "2", "--hold", "nonsense"],
        ["run", "p.hs", "--robot", "ws://localhost:1"],
        ["run", "p.hs", "--explain", "never"],
        ["run", "p.hs", "--provenance"],
        ["check", "p.hs"],
        ["class", "delete"],
        ["class", "list", "-o", "x"],
        ["serve", "--runs", "0"],
        ["serve", "--port", "70000"],
        ["serve", "--robot", "nameless"],
    ],
    ids=" ".join,
)
def test_no_command_says_anything_in_english(
    command: list[str], here: Here, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the pseudo-language all letters of a table have accents: a word in plain letters is in no table."""
    monkeypatch.setenv("LC_ALL", "en_XA.UTF-8")
    (tmp_path / "p.hs").write_text("drive:0.5")
    (tmp_path / "broken.rosy").write_text("{}")
    (tmp_path / "flat.json").write_text('{"size": [5, 4], "start": {"x": 1, "y": 1}, "tiles": ["."]}')
    done = here(*command)
    said = done.stderr + "".join(line for line in done.stdout.splitlines() if not line.startswith("{"))
    assert said.strip() != ""
    names = [path.name for path in tmp_path.iterdir()]
    given = re.findall("[A-Za-z]{3,}", " ".join([*command, *names]))
    assert set(re.findall("[A-Za-z]{3,}", said)) - _KEPT - set(given) == set()


# Names of ours, of options and of formats.
_NAMES = """
rosy help json start run class list export rooms file robot action world family name like ROOM off max int float tiles
size seconds explain provenance trace check build lsp replay robots room command serve node
"""

_KEPT = set(re.findall("[A-Za-z]{3,}", f"{_NAMES} {_ALL_PROPERTIES} {' '.join(world_names())}"))
