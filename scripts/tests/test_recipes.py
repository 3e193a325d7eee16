"""The recipes in CONTRIBUTING.md: each file that they name exists, and each npm script."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SECTION = (ROOT / "CONTRIBUTING.md").read_text().split("## Where does a new thing go?")[1].split("\n## ")[0]
RECIPES = {match[1]: match[0] for match in re.finditer(r"^- \*\*(.+?):\*\*.*?(?=^- \*\*|\Z)", SECTION, re.M | re.S)}

PARTS = ("codegen/", "editor/", "examples/", "protocol/", "rosy-hs/", "scripts/", "sim-service/", "e2e-tests/", "CHANGELOG.md")


def named(recipe: str) -> list[str]:
    """The paths from the root in a recipe. A placeholder such as `<name>` stands for any name."""
    words = [word for code in re.findall(r"`([^`]+)`", recipe) for word in code.split()]
    return [word for word in words if word.startswith(PARTS)]


def test_all_recipes_are_there() -> None:
    wanted = {"A block", "A sensor or command", "A robot", "An explained mistake", "A room", "A text on the page or on a block", "A language"}
    assert wanted <= set(RECIPES)


@pytest.mark.parametrize("title", RECIPES)
def test_a_recipe_names_files_that_exist(title: str) -> None:
    paths = named(RECIPES[title])
    assert paths
    assert [path for path in paths if not list(ROOT.glob(re.sub(r"<[a-z]+>", "*", path.rstrip("/"))))] == []


def test_npm_scripts_in_recipes_exist() -> None:
    found = re.findall(r"npm run (\S+) -w (\w+)", SECTION)
    assert found
    missing = [name for name, part in found if name not in json.loads((ROOT / part / "package.json").read_text())["scripts"]]
    assert missing == []
