"""The distribution holds every package of the service, and the files that its code reads."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["setuptools"]
FOLDERS = sorted({path.parent for path in (ROOT / "rosy_sim").rglob("*.py")})


def test_packages_are_found_and_not_listed() -> None:
    assert SETTINGS["packages"] == {"find": {"include": ["rosy_sim*"], "exclude": ["rosy_sim.bench*"]}}


def test_nothing_that_is_packaged_imports_a_benchmark() -> None:
    """The benchmarks are left out of the distribution and of installed trees."""
    users = [
        str(path.relative_to(ROOT))
        for folder in FOLDERS
        if folder.relative_to(ROOT).parts[:2] != ("rosy_sim", "bench")
        for path in folder.glob("*.py")
        if re.search(r"^\s*(?:from|import) (?:\.|rosy_sim)[\w.]*\bbench\b", path.read_text("utf-8"), re.MULTILINE)
    ]
    assert users == []


def test_every_folder_with_code_is_a_package_that_can_be_found() -> None:
    assert [str(folder) for folder in FOLDERS if not (folder / "__init__.py").exists()] == []


def test_every_file_beside_the_code_is_packaged_or_documentation() -> None:
    packaged = SETTINGS["package-data"]
    missing = [
        str(path.relative_to(ROOT))
        for folder in FOLDERS
        for path in folder.iterdir()
        if path.is_file() and path.suffix not in (".py", ".md") and not _is_data(path, packaged)
    ]
    assert missing == []


def _is_data(path: Path, packaged: dict[str, list[str]]) -> bool:
    package = ".".join(path.parent.relative_to(ROOT).parts)
    return any(path.match(pattern) for pattern in packaged.get(package, []))
