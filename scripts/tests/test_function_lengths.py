"""Lengths of functions: those that are too long are found, in both languages."""

from __future__ import annotations

from pathlib import Path

from function_lengths import MOST_LINES, function_length_breaches, haskell_functions, python_functions

_HASKELL = """-- | Two equations, and a comment between them.
describe :: Int -> String
describe 0 = "none"
-- The rest.
describe n
  | n < 0 = "fewer"

  | otherwise = more
  where
    more = "some"

{- A remark
over two lines. -}
(<+>) :: Int -> Int -> Int
(<+>) = (+)
data Side
  = Left
  | Right
instance Show Side where
  show _ = "side"
unit :: ()
unit = ()
"""

_PYTHON = '''def outer() -> None:
    """Says what it is."""

    async def inner() -> None:
        pass


class Thing:
    @property
    def size(self) -> int:
        return 1
'''


def test_equations_of_one_name_are_one_function() -> None:
    assert list(haskell_functions(_HASKELL)) == [("describe", 3, 8), ("(<+>)", 15, 1), ("unit", 22, 1)]


def test_functions_within_others_count_as_well() -> None:
    assert list(python_functions(_PYTHON)) == [("outer", 1, 5), ("inner", 4, 2), ("size", 10, 2)]


def test_a_function_that_is_too_long_is_named_with_its_place(tmp_path: Path) -> None:
    haskell, python = Path("rosy-hs/worker/Long.hs"), Path("scripts/long.py")
    generated, test = Path("rosy-hs/robots/generated/Long.hs"), Path("rosy-hs/test-worker/Long.hs")
    for path in (haskell, python, generated, test):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
    for path in (haskell, generated, test):
        (tmp_path / path).write_text("fits = do\n" + "  step\n" * (MOST_LINES - 1) + "\nlong = do\n" + "  step\n" * MOST_LINES)
    (tmp_path / python).write_text("def fits():\n" + "    step()\n" * (MOST_LINES - 1) + "def long():\n" + "    step()\n" * MOST_LINES)
    assert list(function_length_breaches(tmp_path, [haskell, python, generated, test])) == [
        "rosy-hs/worker/Long.hs:82: long has 81 lines; a function of more than 80 is several",
        "scripts/long.py:81: long has 81 lines; a function of more than 80 is several",
    ]
