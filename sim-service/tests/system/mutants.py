"""
Texts to try the worker with: random bytes, and changed programs.

Half of the mutants are wild, as if a cat had walked over the keys. The others are tame: changed by what they mean, so
that many are programs still, and run: a number, a name of the same kind, a declaration less, two in another order,
a name given another name throughout. All of it follows from a seed.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from pathlib import Path

__all__ = ["texts"]

ROOT = Path(__file__).resolve().parents[3]

_WORDS = ["where", "let", "in", "case", "of", "data", "class", "instance", "deriving", "do", "Memory", "import"]

_ALIKE = [
    ["LeftBumper", "CenterBumper", "RightBumper"],
    ["LeftCliff", "CenterCliff", "RightCliff"],
    ["LeftWheel", "RightWheel"],
    ["Button0", "Button1", "Button2"],
    ["Pressed", "Released"],
    ["Hole", "Floor"],
    ["Air", "Ground"],
    ["Black", "Green", "Orange", "Red"],
    ["OnSound", "OffSound", "RechargeSound", "ButtonSound", "ErrorSound", "CleaningStartSound", "CleaningEndSound"],
    ["Led1", "Led2"],
    ["True", "False"],
    [" + ", " - ", " * "],
    [" < ", " > ", " <= ", " >= ", " == ", " /= "],
    [" && ", " || "],
    ["sin", "cos", "sqrt", "abs", "negate"],
    ["Bumper", "Cliff", "Wheel", "Button"],
    ["Velocity", "Position"],
]
"""Words that can often stand in each other's place."""

_NUMBERS = ["0", "1", "7", "1000000", "0.5", "2.25", "1e9", "-1", "99999999999999999999"]

_NAMES = ["thing", "x'", "wait", "turn", "once", "über", "seconds", "init", "a_long_name_that_says_it_all"]

_NUMBER = re.compile(r"(?<![\w.])\d+(\.\d+)?(?![\w.])")

_NAME = re.compile(r"^([a-z]\w*) ::", re.MULTILINE)


def texts(count: int, seed: int) -> Iterator[tuple[str, str]]:
    """Names and texts: as many random ones as mutants."""
    examples = [file.read_text("utf-8") for file in sorted(ROOT.glob("examples/*/Main.hs"))]
    mistakes = [file.read_text("utf-8") for file in sorted(ROOT.glob("rosy-hs/test-worker/gallery/*/Main.hs"))]
    for kind in ("random", "mutant"):
        for number in range(count):
            dice = random.Random(f"{seed} {kind} {number}")
            if kind == "random":
                text = _random_text(dice)
            elif number % 2:
                text = _tame(dice, examples)
            else:
                text = _wild(dice, [*examples * 5, *mistakes])
            yield f"{kind} {number} of seed {seed}", text


def _random_text(dice: random.Random) -> str:
    """Random bytes, read as text in one way or another."""
    octets = dice.randbytes(dice.choice((1, 10, 100, 1000)))
    return octets.decode(dice.choice(("latin-1", "utf-8", "utf-16-le")), "replace")


def _tame(dice: random.Random, originals: list[str]) -> str:
    text = dice.choice(originals)
    for _ in range(dice.choice((1, 2, 3, 5))):
        match dice.randrange(7):
            case 0 | 1:
                text = _other_number(dice, text)
            case 2 | 3:
                text = _other_word(dice, text)
            case 4:
                text = _another_name(dice, text)
            case 5:
                text = _other_order(dice, text)
            case _:
                text = _one_less(dice, text)
    return text


def _other_number(dice: random.Random, text: str) -> str:
    found = list(_NUMBER.finditer(text))
    if not found:
        return text
    one = dice.choice(found)
    new = dice.choice((*_NUMBERS, str(dice.random())))
    return f"{text[: one.start()]}{f'({new})' if new.startswith('-') else new}{text[one.end() :]}"


def _other_word(dice: random.Random, text: str) -> str:
    """One of some words that are alike for another, once or wherever it stands."""
    group = dice.choice([group for group in _ALIKE if any(word in text for word in group)] or [[" "]])
    old = dice.choice([word for word in group if word in text] or [" "])
    new = dice.choice(group)
    pattern = re.escape(old) if old.startswith(" ") else rf"\b{old}\b"
    return re.sub(pattern, lambda _: new, text, count=dice.choice((0, 0, 1)))


def _another_name(dice: random.Random, text: str) -> str:
    """A function called otherwise, wherever it stands: also like one of Rosy's own."""
    names = _NAME.findall(text)
    if not names:
        return text
    new = dice.choice(_NAMES)
    return re.sub(rf"\b{dice.choice(names)}\b", lambda _: new, text)


def _parts(text: str) -> list[str]:
    """Top-level pieces: what starts in the first column, with its indented lines and the blank ones behind it."""
    return re.split(r"\n(?=\S)", text)


def _other_order(dice: random.Random, text: str) -> str:
    """Two blocks of lines between blank ones have changed places."""
    blocks = text.rstrip("\n").split("\n\n")
    one, two = dice.randrange(len(blocks)), dice.randrange(len(blocks))
    blocks[one], blocks[two] = blocks[two], blocks[one]
    return "\n\n".join(blocks) + "\n"


def _one_less(dice: random.Random, text: str) -> str:
    """A line of the top level is gone: a signature, an equation, a whole definition."""
    parts = _parts(text)
    parts.pop(dice.randrange(len(parts)))
    return "\n".join(parts)


def _wild(dice: random.Random, originals: list[str]) -> str:
    text = dice.choice(originals)
    for _ in range(dice.choice((1, 1, 2, 3, 10))):
        at, to = sorted(dice.randrange(len(text) + 1) for _ in range(2))
        to = min(to, at + dice.choice((1, 5, 40)))
        match dice.randrange(7):
            case 0:
                text = text[:at] + text[to:]
            case 1:
                text = text[:at] + dice.choice("(){}[]=|\\:;,.'\"`_-<>@#$ \n\t0aZ∀λ") + text[at:]
            case 2:
                text = text[:at] + text[at:to] * dice.choice((2, 3, 50)) + text[to:]
            case 3:
                other = dice.choice(originals)
                begin = dice.randrange(len(other) + 1)
                text = text[:at] + other[begin : begin + 60] + text[to:]
            case 4:
                lines = text.splitlines(keepends=True)
                dice.shuffle(lines)
                text = "".join(lines)
            case 5:
                text = f"{text[:at]} {dice.choice(_WORDS)} {text[to:]}"
            case _:
                text = text[:at] + re.sub(r"\b\d", lambda _: str(dice.randrange(10)), text[at:], count=2)
    return text
