"""
Import rules of the Python service: which package may import which, what may not be imported at all, and no cycles.

In: the sources below ``sim-service/rosy_sim``. Out: one sentence per breach. All imports count, those inside of
functions and those for types only as well.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

__all__ = ["breaches", "dependents"]

LAYERS = (
    (
        "atomic_file",
        "attempts",
        "boot_clock",
        "config",
        "errors",
        "files",
        "memory_ceiling",
        "robot_description",
        "sentences",
        "text_lines",
        "token_bucket",
        "version",
        "interruptible",
        "garbage_collection",
    ),
    ("world",),
    ("robots",),
    ("worlds",),
    ("maps",),
    ("wire",),
    ("explain",),
    ("accounting",),
    ("worker",),
    ("ros2",),
    ("programs",),
    ("run",),
    ("previews",),
    ("rooms",),
    ("lessons",),
    ("recordings",),
    ("ownership",),
    ("classroom",),
    ("web", "lsp"),
    ("cluster",),
    ("bench", "cli", "doctor", "__main__"),
)
"""A module imports from its own layer and from those before it. The list in sim-service/README.md explains them."""

MOST_MODULES = 16

SYSTEM = frozenset({"asyncio", "select", "selectors", "socket", "subprocess", "threading", "starlette", "uvicorn"})

FORBIDDEN = {
    "world": SYSTEM | {"json", "msgspec", "time"},
    "robots": SYSTEM | {"json", "msgspec", "time"},
    "wire": SYSTEM | {"time"},
    "explain": SYSTEM | {"time"},
    "run.steps.lockstep": SYSTEM | {"time"},
    "classroom.store.class_store": SYSTEM,
    "classroom.pupil_state": SYSTEM | {"time"},
    "run.headless_run": frozenset({"asyncio"}),
}
"""Modules from elsewhere that a part must not import: it does no I/O, or runs without an event loop."""

_RANK = {part: rank for rank, parts in enumerate(LAYERS) for part in parts}


def breaches(root: Path) -> Iterator[str]:
    """One sentence per rule broken below ``root``, the folder of the package."""
    modules = {_name(path, root): path for path in sorted(root.rglob("*.py"))}
    for part in FORBIDDEN.keys() - modules.keys():
        yield f"scripts/python_imports.py: FORBIDDEN names {part}, which is no module"
    graph: dict[str, set[str]] = {}
    for name, path in modules.items():
        inside, outside = _imports(name, path, modules)
        graph[name] = inside
        where = path.relative_to(root).as_posix()
        for used in sorted(outside):
            if any(f"{name}.".startswith(f"{part}.") and used in names for part, names in FORBIDDEN.items()):
                yield f"{where}: imports {used}; sim-service/README.md says what this part must not import"
        for used in sorted(inside):
            if name and _rank(used) > _rank(name):
                yield f"{where}: imports {used}, which is above it; sim-service/README.md has the order"
    sizes = Counter(path.parent for path in modules.values() if path.name != "__init__.py")
    for folder, size in sorted(sizes.items()):
        if size > MOST_MODULES:
            yield f"{folder.relative_to(root.parent).as_posix()}: has {size} modules; more than {MOST_MODULES} are two folders"
    for cycle in _cycles(graph):
        yield f"import cycle: {' -> '.join(cycle)}"


def dependents(root: Path, changed: Iterable[str]) -> set[str]:
    """
    The files below ``root``, a folder with packages, that import one of the changed files, directly or through others,
    and the changed ones themselves. All are relative to ``root``.
    """
    modules = {_name(path, root): path for path in sorted(root.rglob("*.py")) if "site-packages" not in path.parts}
    importers: dict[str, set[str]] = {}
    for name, path in modules.items():
        inside, _ = _imports(name, path, modules)
        for used in inside | _absolute(path, modules):
            importers.setdefault(used, set()).add(name)
    found: set[str] = set()
    reached = [name for name, path in modules.items() if path.relative_to(root).as_posix() in set(changed)]
    while reached:
        name = reached.pop()
        if name not in found:
            found.add(name)
            reached += importers.get(name, ())
    return {modules[name].relative_to(root).as_posix() for name in found}


def _absolute(path: Path, modules: dict[str, Path]) -> set[str]:
    """The modules below the same root that a file imports by their full names."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names & modules.keys()


def _name(path: Path, root: Path) -> str:
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _rank(name: str) -> int:
    return _RANK.get(name.partition(".")[0], len(LAYERS))


def _imports(name: str, path: Path, modules: dict[str, Path]) -> tuple[set[str], set[str]]:
    """The modules of the package, and the top-level modules from elsewhere, that a file imports."""
    inside: set[str] = set()
    outside: set[str] = set()
    parts = name.split(".") if name else []
    package = parts if path.name == "__init__.py" else parts[:-1]
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            outside |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            outside.add((node.module or "").partition(".")[0])
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] + (node.module.split(".") if node.module else [])
            for alias in node.names:
                target = ".".join([*base, alias.name])
                inside.add(target if target in modules else ".".join(base))
    return inside, outside


def _cycles(graph: dict[str, set[str]]) -> Iterator[list[str]]:
    """A cycle for each module from which a walk along imports comes back to a module that is still open."""
    done: set[str] = set()

    def walk(name: str, path: list[str]) -> Iterator[list[str]]:
        if name in path:
            yield [*path[path.index(name) :], name]
            return
        if name in done:
            return
        for used in sorted(graph.get(name, ())):
            yield from walk(used, [*path, name])
        done.add(name)

    for name in sorted(graph):
        yield from walk(name, [])
