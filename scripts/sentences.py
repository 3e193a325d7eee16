"""
Translations of sentences, as a check: every template of the source text stands in every language's table, and takes its arguments.

In: calls of ``tr`` and ``trWith`` in ``rosy-hs/worker``, ``rosy-hs/src``, ``rosy-hs/robots``, ``rosy-hs/app`` (``Rosy.Sentence``),
calls of ``tr`` and ``template`` in ``sim-service/rosy_sim``
(``rosy_sim.sentences.sentence``) and in what packs Rosy, sentences of ``./rosy`` itself (``shell_sentences.py``), titles of rooms and examples, the tables
and help pages in ``languages``. Out: one sentence per breach. ``python3 scripts/sentences.py`` prints the templates as a table without
translations, to begin a language with; with the name of a table, those that it lacks.
"""

from __future__ import annotations

import ast
import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from shell_sentences import shell_bypasses, shell_templates

ROOT = Path(__file__).resolve().parent.parent
_HASKELL = ("rosy-hs/worker", "rosy-hs/src", "rosy-hs/robots", "rosy-hs/app")
TABLES = "languages/*/sentences.json"
# Defines both functions and quotes them in its comments.
_DEFINITION = Path("rosy-hs/src/Rosy/Sentence.hs")
_SERVICE = Path("sim-service/rosy_sim")
_PACKAGES = ("scripts/package.py", "scripts/installation/*.py")
_SHELL = ("rosy", "scripts/lib/*.sh")
_LANGUAGES = Path("languages")
_ROOMS = _SERVICE / "worlds"
_EXAMPLES = Path("examples")

_CALL = re.compile(r"(?<![\w'.\"])tr(With)?(?![\w'])")
_LITERAL = re.compile(r'\s*"((?:[^"\\\n]|\\.)*)"')
_ARGUMENT = re.compile(r'"([A-Za-z]+)" =[:#*@] ')
_PLACEHOLDER = re.compile(r"\{(?:([A-Za-z]+) )?([A-Za-z]+)\}")

# Three words of English that follow one another.
_ENGLISH = re.compile(r"[A-Za-z']{2,} [a-z]{2,} [a-z]{2,}")
# Calls whose texts are known sentences, or are not for readers: documentation of a schema, patterns.
_NO_SENTENCES = {"tr", "template", "Meta", "compile", "fullmatch", "match", "_about_argument", "_report_error", "ArgumentParser", "add_argument"}
_SENTENCE_ERRORS = {
    "RosyError", "BadInput", "OutputFailed", "RobotMissing", "WorkerLost", "ArenaError", "BadProperty", "BadPattern", "BadStep", "ActionRefused", "BadMessage",
    "TreeError",
}  # fmt: skip
# Modules whose English is not for users, or is put into words elsewhere.
_EXEMPT = {
    "bench": "measurements, for developers",
    "classroom/exports/study_readme.py": "description of a data set, for researchers",
    "explain/wording.py": "English of explanations, which the page words by their ids",
    "lessons/schema.py": "documentation of a schema",
    "lessons/checks.py": "documentation of a schema",
    "lessons/lesson_file.py": "patterns of msgspec's messages, and documentation of a schema",
    "previews/preview_process.py": "log of a process of its own",
    "sentences/usage_errors.py": "patterns of argparse's messages",
    "wire/line_splitter.py": "technical: a broken protocol",
    "ros2/bridge.py": "answers to ROS clients",
    "ros2/transports/dds_messages.py": "answers to ROS clients",
    "ros2/outgoing_frames.py": "answers to ROS clients",
    "robots/kobuki/dock_drive.py": "results of an action, in upstream's words",
    "robots/shared/navigate_drive.py": "results of an action, which the page words",
    "wire/action_frames.py": "answers to ROS clients",
    "world/action_goals.py": "answers to ROS clients",
    "wire/ros/ros_messages.py": "answers to ROS clients",
    "wire/ros/rosbridge.py": "answers to ROS clients",
    "wire/ros/rosbridge_fragments.py": "answers to ROS clients",
}

# protocol/README.md, section 1.1.
FORMATS = {"", "a", "or", "then", "count"}
# What a table says besides its sentences.
FORMS = {"type": "{type}", "function": "{type}", "alternative": "", "sequence": "", "numbers": ""}


def placeholders(template: str) -> set[str]:
    return {name for _, name in _PLACEHOLDER.findall(template)}


def templates(source: str) -> Iterator[tuple[int, str | None, set[str] | None]]:
    """Line, template and names of arguments of every call; ``None`` for what is not written out at the call."""
    code = "\n".join("" if line.lstrip().startswith("--") else line for line in source.split("\n"))
    for call in _CALL.finditer(code):
        line = code.count("\n", 0, call.start()) + 1
        literal = _LITERAL.match(code, call.end())
        if literal is None:
            yield line, None, None
            continue
        template = json.loads(f'"{literal[1]}"')
        if call[1] is None:
            yield line, template, set()
            continue
        rest = code[literal.end() :].lstrip()
        yield line, template, set(_ARGUMENT.findall(rest[: _closing(rest)])) if rest.startswith("[") else None


def _closing(text: str) -> int:
    """The end of the list that a text begins with; string literals may hold brackets."""
    depth = 0
    for token in re.finditer(r'"(?:[^"\\\n]|\\.)*"|[\[\]]', text):
        depth += {"[": 1, "]": -1}.get(token[0], 0)
        if depth == 0:
            return token.end()
    return len(text)


def service_templates(source: str) -> Iterator[tuple[int, str | None, set[str] | None]]:
    """The same of Python source text."""
    for node in ast.walk(ast.parse(source)):
        of_table = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "template"
        if not isinstance(node, ast.Call) or not (of_table or _called(node.func) == "tr"):
            continue
        template = node.args[0].value if len(node.args) == 1 and isinstance(node.args[0], ast.Constant) else None
        if of_table:
            yield node.lineno, template, placeholders(template) if isinstance(template, str) else None
            continue
        names = [keyword.arg for keyword in node.keywords]
        yield node.lineno, template if isinstance(template, str) else None, None if None in names else {name for name in names if name}


def _called(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else function.attr if isinstance(function, ast.Attribute) else ""


def bypasses(source: str) -> Iterator[tuple[int, str]]:
    """Line and text of English sentences in Python source text that are in no call of ``tr``."""
    tree = ast.parse(source)
    known: set[int] = set()
    for node in ast.walk(tree):
        is_documentation = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        is_internal = isinstance(node, ast.Raise | ast.Assert) and not _raises_sentence(node)
        if is_documentation or is_internal or (isinstance(node, ast.Call) and _called(node.func) in _NO_SENTENCES):
            known |= {id(inner) for inner in ast.walk(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in known and _ENGLISH.search(node.value):
            yield node.lineno, node.value


def _raises_sentence(node: ast.Raise | ast.Assert) -> bool:
    """Whether an exception carries a sentence for users; all others are technical: a broken protocol, a fault of our own."""
    return isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and _called(node.exc.func) in _SENTENCE_ERRORS


def content_ids(root: Path = ROOT) -> set[str]:
    """Titles of the gallery's rooms, of their goals and of those in lessons, and what the examples teach: each is its own id."""
    found: set[str] = set()
    rooms = [json.loads(path.read_text()) for path in sorted((root / _ROOMS).glob("*.json"))]
    lessons = [json.loads(path.read_text()) for path in sorted((root / _EXAMPLES).glob("lessons/*/lesson.json"))]
    for room in [*rooms, *(lesson["room"] for lesson in lessons)]:
        found |= {said for said in (room.get("title"), *(goal.get("title") for goal in room.get("goals", []))) if said}
    for path in sorted((root / _EXAMPLES).glob("*/README.md")):
        if (path.parent / "program.rosy").is_file():
            found.add(" ".join(path.read_text().split("\n\n")[1].split()))
    return found


def _sources(root: Path) -> Iterator[tuple[Path, Iterator[tuple[int, str | None, set[str] | None]]]]:
    """Each file with its templates."""
    for folder in _HASKELL:
        for path in sorted((root / folder).rglob("*.hs")):
            if path != root / _DEFINITION:
                yield path, templates(path.read_text())
    for path in [*sorted((root / _SERVICE).rglob("*.py")), *_matching(root, _PACKAGES)]:
        yield path, service_templates(path.read_text())
    for path in _matching(root, _SHELL):
        yield path, shell_templates(path.read_text())


def _matching(root: Path, patterns: tuple[str, ...]) -> list[Path]:
    return [path for pattern in patterns for path in sorted(root.glob(pattern))]


def haskell_ids(root: Path, folders: tuple[str, ...]) -> set[str]:
    """The templates of some folders of Haskell source text."""
    paths = [path for folder in folders for path in sorted((root / folder).rglob("*.hs")) if path != root / _DEFINITION]
    return {template for path in paths for _, template, _ in templates(path.read_text()) if template is not None}


def sentence_ids(root: Path = ROOT) -> set[str]:
    """All templates of the worker and the service, and the content's sentences."""
    return content_ids(root) | {t for _, found in _sources(root) for _, t, _ in found if t is not None}


def sentence_breaches(root: Path = ROOT) -> Iterator[str]:
    """What is wrong with the templates and the tables, each as a sentence."""
    for path, found in _sources(root):
        name = path.relative_to(root).as_posix()
        for line, template, given in found:
            if template is None or given is None:
                yield f"{name}:{line}: write the template and its arguments at the call, so that they can be checked"
            elif placeholders(template) != given:
                yield f"{name}:{line}: the arguments {sorted(given)} do not fit the template “{template}”"
    for path, line, text in _all_bypasses(root):
        yield f"{path.relative_to(root).as_posix()}:{line}: “{text}” is in no table of sentences; make it with tr, in a script with sentence"
    ids = sentence_ids(root)
    for path in sorted(root.glob(TABLES)):
        name, text = path.relative_to(root).as_posix(), path.read_text()
        yield from _table_breaches(name, json.loads(text), ids)
        yield from _help_breaches(root, path.parent.name)
        if text.strip() != json.dumps(json.loads(text), indent=2, ensure_ascii=False):
            yield f"{name}: scripts/lib/sentences.sh reads one sentence a line, as json.dumps(…, indent=2, ensure_ascii=False) writes them"


def _all_bypasses(root: Path) -> Iterator[tuple[Path, int, str]]:
    for path in sorted((root / _SERVICE).rglob("*.py")):
        module = path.relative_to(root / _SERVICE).as_posix()
        if module not in _EXEMPT and module.partition("/")[0] not in _EXEMPT:
            yield from ((path, *found) for found in bypasses(path.read_text()))
    for path in _matching(root, _PACKAGES):
        yield from ((path, line, text) for line, text in bypasses(path.read_text()) if not _NO_PROSE.match(text))
    for path in _matching(root, _SHELL):
        yield from ((path, *found) for found in shell_bypasses(path.read_text()))


# Scripts, commands, and the descriptions that Debian's tools read.
_NO_PROSE = re.compile(r"#!|\[Unit\]|Package: |sudo ")

# What every translation of a help page names as the English page does: options, file endings, and commands to type.
_HELP_TOKENS = re.compile(r"--[a-z][a-z-]*|(?<=\./rosy )[a-z-]+|[a-z]+://|\.(?:hs|rosy|json|zip)\b")


def _help_breaches(root: Path, language: str) -> Iterator[str]:
    """Help pages that a language lacks, or that name other options and commands than the English ones."""
    for page in sorted((root / _LANGUAGES / "en" / "help").glob("*.txt")):
        translated = root / _LANGUAGES / language / "help" / page.name
        name = translated.relative_to(root).as_posix()
        if not translated.is_file():
            yield f"{name}: there is no such page; ./rosy help would be in English"
        else:
            ours, theirs = (sorted(set(_HELP_TOKENS.findall(file.read_text()))) for file in (page, translated))
            if ours != theirs:
                yield f"{name}: names other options, commands or files than the English page: {', '.join(sorted(set(ours) ^ set(theirs)))}"


def _table_breaches(name: str, table: dict[str, object], ids: set[str]) -> Iterator[str]:
    said = table.get("sentences")
    if not isinstance(said, dict) or set(table) != {*FORMS, "sentences"}:
        yield f"{name}: a table has {', '.join(FORMS)} and sentences"
        return
    for template in sorted(ids - set(said)):
        yield f"{name}: nothing is said for “{template}”"
    for template in sorted(set(said) - ids):
        yield f"{name}: nothing says “{template}”"
    for template, translation in said.items():
        if not translation:
            yield f"{name}: nothing is said for “{template}”"
        elif placeholders(translation) != placeholders(template):
            yield f"{name}: the translation of “{template}” has other arguments: “{translation}”"
        elif unknown := {form for form, _ in _PLACEHOLDER.findall(translation)} - FORMATS:
            yield f"{name}: “{translation}” has an unknown format: {', '.join(sorted(unknown))}"
        elif placeholder_left(translation):
            yield f"{name}: “{translation}” has a brace that belongs to no argument"


def placeholder_left(translation: str) -> bool:
    """Whether braces around one or two words remain, which a reader of the table may have misspelled."""
    return re.search(r"\{[^{}=]*\}", _PLACEHOLDER.sub("", translation)) is not None


def _blank(known: set[str]) -> str:
    """A table without translations, of what is not known yet."""
    sentences = dict.fromkeys(sorted(sentence_ids() - known), "")
    return json.dumps({**FORMS, "numbers": [""] * 13, "sentences": sentences}, indent=2, ensure_ascii=False)


if __name__ == "__main__":
    print(_blank(set(json.loads(Path(sys.argv[1]).read_text())["sentences"]) if len(sys.argv) > 1 else set()))
