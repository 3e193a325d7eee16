"""
Characters that look right and are not, and characters that cannot be seen: each is named at its place, and its repair
gives the program that was meant.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator

import pytest

from rosy_sim.config import discover
from rosy_sim.wire.problem import Edit, Place, Problem
from rosy_sim.worker.blocking_worker import BlockingWorker

from .real_runs import worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


def _program(expression: str) -> str:
    """Comments and texts have every character in them, which they may."""
    return f"""-- − – × “ ” ‘ ’ « » ＋ о \u200b {{- … -}}
greet :: Bumper -> Say
greet _ = Say "− – × “ ” ‘ ’ « » ＋ о"

move :: () -> Velocity
move () = Velocity ({expression}) 0

main = simulate (move, greet)
"""


SIGNS = {
    "-": ("3 - 2", "−‐‑‒–—―－"),
    "*": ("3 * 2", "×∗·⋅＊"),
    "/": ("3 / 2", "÷∕⁄／"),
    "+": ("3 + 2", "＋"),
    "<=": ("if 1 <= 2 then 1 else 2", "≤"),
    ">=": ("if 1 >= 2 then 1 else 2", "≥"),
    "/=": ("if 1 /= 2 then 1 else 2", "≠"),
    "..": ("sum [1 .. 3]", "…"),
    "&&": ("if True && True then 1 else 2", "∧"),
    "||": ("if True || True then 1 else 2", "∨"),
    '"': ('fromIntegral (length "ab")', "“”„«»‹›"),
    "'": ("if 'a' == 'b' then 1 else 2", "‘’‚´′＇"),
    "(": ("(1) + 1", "（"),
    "[": ("sum [1]", "［"),
    ",": ("sum [1, 2]", "，"),
    "1": ("2 + 1", "１"),
    "->": ("(\\x -> x) 1", "→"),
    "o": ("cos 1", "оο"),
    "p": ("pi", "рρ"),
    "s": ("sin 1", "ѕ"),
    "c": ("cos 1", "с"),
    "m": ("min 1 2", "ｍ"),
}
"""Expressions with a sign or a letter, and the characters that are taken for it."""

CASES = [(plain, odd, meant) for plain, (meant, odds) in SIGNS.items() for odd in odds]

UNSEEN = (
    "\u00ad\u200b\u200c\u200d\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2060\u2066\u2067\u2068\u2069\ufeff\ufe0f\u061c"
)


def _repaired(source: str, edits: list[Edit]) -> str:
    def offset(place: Place) -> int:
        lines = source.split("\n")
        return sum(len(line) + 1 for line in lines[: place.line - 1]) + place.column - 1

    for edit in sorted(edits, key=lambda edit: (edit.start.line, edit.start.column), reverse=True):
        source = source[: offset(edit.start)] + edit.text + source[offset(edit.end) :]
    return source


def _errors(worker: BlockingWorker, source: str) -> list[Problem]:
    return [problem for problem in worker.check(source).problems if problem.severity == "error"]


@pytest.mark.parametrize(("plain", "odd", "meant"), CASES, ids=lambda text: ascii(text).strip("'"))
def test_a_character_that_looks_right_is_named_and_replaced(
    worker: BlockingWorker, plain: str, odd: str, meant: str
) -> None:
    source = _program(meant.replace(plain, odd))
    found, *others = _errors(worker, source)
    assert found.kind == "character"
    assert found.start is not None
    assert source.split("\n")[found.start.line - 1][found.start.column - 1] == odd
    assert f"‘{odd}’" in found.message
    assert others == []
    assert found.fixes
    # The last fix repairs all of them.
    assert _repaired(source, found.fixes[-1].edits) == _program(meant)


@pytest.mark.parametrize("unseen", UNSEEN, ids=ascii)
@pytest.mark.parametrize("before", ["", '"'], ids=["in the program", "in a text"])
def test_a_character_that_cannot_be_seen_is_named_and_removed(worker: BlockingWorker, unseen: str, before: str) -> None:
    if unseen == "\ufe0f" and before:
        pytest.skip("GHC accepts it in a text, where it belongs to the sign in front of it")
    meant = _program("3 + 2" if before == "" else 'fromIntegral (length "ab")')
    at = meant.index("3 + 2") + 2 if before == "" else meant.index('"ab"') + 1
    source = meant[:at] + unseen + meant[at:]
    found, *others = _errors(worker, source)
    assert (found.kind, others) == ("character", [])
    name = unicodedata.name(unseen).lower()
    assert name in found.message or f"U+{ord(unseen):04X}" in found.message
    assert found.fixes
    assert _repaired(source, found.fixes[0].edits) == meant
    assert _errors(worker, meant) == []


def test_all_of_a_text_from_a_word_processor_are_replaced_at_once(worker: BlockingWorker) -> None:
    source = (
        "greet ∷ Bumper → Say\ngreet _ = Say “it’s – here”\n\n"
        "move ∷ () → Velocity\nmove () = Velocity (0.2 × 2 − 0.1) 0\n\nmain = simulate （move， greet）\n"
    )
    found, *_ = _errors(worker, source)
    assert found.fixes
    assert _repaired(source, found.fixes[-1].edits) == (
        'greet :: Bumper -> Say\ngreet _ = Say "it’s – here"\n\n'
        "move :: () -> Velocity\nmove () = Velocity (0.2 * 2 - 0.1) 0\n\nmain = simulate (move, greet)\n"
    )


@pytest.mark.parametrize(
    "control", [c for c in UNSEEN if unicodedata.bidirectional(c)[:2] in ("LR", "RL", "PD", "FS")], ids=ascii
)
def test_a_control_of_the_direction_gets_a_warning_in_a_comment(worker: BlockingWorker, control: str) -> None:
    source = f"main = simulate (Velocity 0.1 0) -- {control} a\n"
    found, *others = [problem for problem in worker.check(source).problems if problem.kind == "direction"]
    assert (found.severity, found.start, others) == ("warning", Place(1, 37), [])


@pytest.mark.parametrize(
    "source",
    [
        "(−) :: Double -> Double -> Double\na − b = a - b\n\nmain = simulate (Velocity (1 − 1) 0)\n",
        "скорость :: Velocity\nскорость = Velocity 0.1 0\n\nmain = simulate скорость\n",
        "{-# LANGUAGE UnicodeSyntax #-}\nf ∷ Double → Velocity\nf x = Velocity x 0\n\nmain = simulate (f 1)\n",
    ],
    ids=["an operator of the program", "a name in another script", "UnicodeSyntax"],
)
def test_what_the_program_means_is_left_alone(worker: BlockingWorker, source: str) -> None:
    assert _errors(worker, source) == []
    broken = source.replace("main", "g = )\nmain")
    assert all(problem.kind != "character" for problem in _errors(worker, broken))
