"""
The borders between the parts, as a check: who may import whom, and what no file may contain.

In: the files git tracks. Out: one sentence per breach, and the counts the test runner reads. It parses nothing deeply: an
import line is enough to see a border crossed. Each sentence names the reason of its rule. ``citations.py`` adds the check of citations.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import python_imports
from citations import citation_breaches
from confusable_characters import confusable_breaches
from extension_table import extension_breaches
from function_lengths import function_length_breaches
from languages import language_breaches
from protection_table import protection_breaches
from robot_sentences import translation_breaches
from robot_typescript import label_breaches
from sentences import sentence_breaches
from tracked_files import tracked_files

ROOT = Path(__file__).resolve().parent.parent

# Modules named GHC.* that belong to base and are no part of the compiler's API.
GHC_IN_BASE = {
    "GHC.Generics", "GHC.Stack", "GHC.TypeLits", "GHC.Conc", "GHC.Exts", "GHC.Float", "GHC.IO",
    "GHC.Records", "GHC.Stats", "GHC.Clock", "GHC.Word", "GHC.Fingerprint", "GHC.Foreign", "GHC.IO.Encoding", "GHC.IO.Handle", "GHC.Base",
}  # fmt: skip

TOP_LEVEL = {
    "README.md", "ARCHITECTURE.md", "DECISIONS.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "rosy", "package.json",
    "package-lock.json", "rosy.cabal", "protocol", "codegen", "editor", "rosy-hs", "sim-service", "examples", "e2e-tests", "languages",
}  # fmt: skip

FOLDERS_WITH_README = ["languages", "protocol", "codegen", "editor", "rosy-hs", "sim-service", "examples", "e2e-tests", "scripts"]

# What would tell where a file was written, or tie a lock file to one registry.
NOWHERE = re.compile(r"/work/(main|wt|shared)|registry\.npmjs\.org|pypi\.org/simple|files\.pythonhosted\.org|deb\.debian\.org")


# What the tables of a language import: one another, the types of tables, how numbers are written, Blockly's own words.
OF_A_LANGUAGE = re.compile(
    r"\./|(\.\./){2}en/page/|\.\./blocks/index\.ts|(\.\./){3}(codegen/src/words|editor/src/words|editor/src/worlds)/|@rosy/codegen/text-file|blockly/msg/"
)


def imports_ts(text: str) -> Iterator[str]:
    yield from re.findall(r"""(?:from|import)\s*\(?\s*["']([^"']+)["']""", text)


def imports_hs(text: str) -> Iterator[str]:
    yield from re.findall(r"^import\s+(?:safe\s+)?(?:\{-#.*?#-\}\s*)?(?:qualified\s+)?(?:\"[^\"]+\"\s+)?([\w.]+)", text, re.M)


def breaches(path: Path, text: str) -> Iterator[str]:
    """The rules that one file breaks, each as the end of a sentence that begins with its name."""
    name = path.as_posix()
    if name.startswith("codegen/src/") or re.match("languages/[^/]+/blocks/", name):
        for used in imports_ts(text):
            if re.match(r"(blockly|@blockly|@codemirror|codemirror|preact|jsdom|node:(net|http|https|dns))", used):
                yield f"imports {used}: codegen knows no Blockly, DOM or network"
            if used.startswith("@rosy/editor") or "/editor/" in used:
                yield f"imports {used}: the editor uses codegen, never the other way round"
        if re.search(r"\b(document|window|fetch|WebSocket|localStorage)\b\s*[.(]", re.sub(r"(//[^\n]*|/\*.*?\*/|`[^`]*`|\"[^\"\n]*\")", "", text, flags=re.S)):
            yield "uses the browser: codegen knows no DOM"
    if name.startswith("languages/"):
        for used in re.findall(r'^import [^"\n]*from "([^"]+)"', text, re.M):
            if not OF_A_LANGUAGE.match(used):
                yield f"imports {used}: a language holds words, and knows the tables' types only"
    if name.startswith(("editor/src/program/", "editor/src/state/", "editor/src/reducers/", "editor/src/values/")):
        for used in imports_ts(text):
            # Change sets and text differences are pure values; both packages serve them.
            if re.match(r"(blockly|@codemirror/(?!(state|merge)$)|codemirror|@?preact)", used):
                yield f"imports {used}: the page's state knows no DOM"
    if name.endswith(".hs") and not name.startswith("examples/"):
        compiler = [u for u in imports_hs(text) if u.startswith("GHC") and u not in GHC_IN_BASE and not u.startswith("GHC.IO")]
        facade = name.startswith(("rosy-hs/worker/Rosy/Worker/Ghc.hs", "rosy-hs/worker/Rosy/Worker/Ghc/"))
        # The worker refuses these programs; nothing is built from them.
        attack = name.startswith("rosy-hs/test-worker/attacks/")
        if compiler and not facade and not attack:
            yield f"imports {compiler[0]}: only Rosy.Worker.Ghc speaks to the compiler"
        if name.startswith("rosy-hs/src/"):
            for used in imports_hs(text):
                if used.startswith(("Ros.", "Rosy.Worker")):
                    yield f"imports {used}: the language knows neither ROS nor the worker"
    if NOWHERE.search(text):
        yield "names a place that exists on one machine or in one registry only"


def folder_breaches(files: list[Path]) -> Iterator[str]:
    decisions = (ROOT / "DECISIONS.md").read_text() if (ROOT / "DECISIONS.md").exists() else ""
    for top in sorted({f.parts[0] for f in files} - TOP_LEVEL):
        if f"`{top}`" not in decisions:
            yield f"{top}: a new top-level name needs its reason in DECISIONS.md"
    for folder in FOLDERS_WITH_README:
        readme = ROOT / folder / "README.md"
        head = readme.read_text()[:1500] if readme.exists() else ""
        if not ("**In:**" in head and "**Out:**" in head and "**Never:**" in head):
            yield f"{folder}/README.md: says first what goes in, what comes out and what the folder never does"


# Sources that may name the simulated robot outside the folders for robots: package lists, and the names of the original library.
NAMING_A_ROBOT = {"rosy.cabal", "sim-service/pyproject.toml", "rosy-hs/worker/Rosy/Worker/Explanation/OriginalVocabulary.hs"}

# Descriptions of robots, code for one robot, what is generated, examples, tests and documentation.
ABOUT_ROBOTS = re.compile(
    r"^protocol/|^languages/[^/]+/sentences\.json$|/robots/|^examples/|/examples/|test|/bench/|corpus|generated|Rosy/Robot/Known\.hs$|/ros/msg/|\.(md|txt)$|"
    r"^scripts/"
)


def robot_breaches(path: Path, text: str) -> Iterator[str]:
    """Mentions of the simulated robot where code is for any robot."""
    name = path.as_posix()
    if "kobuki" in text.lower() and name not in NAMING_A_ROBOT and not ABOUT_ROBOTS.search(name):
        yield "names Kobuki: what is particular to a robot belongs to protocol/robots or a robots folder"


def main() -> int:
    files = tracked_files(ROOT)
    found: list[str] = [*folder_breaches(files), *citation_breaches(ROOT, files)]
    found += [*language_breaches(ROOT), *label_breaches()]
    found += [*extension_breaches(ROOT), *protection_breaches(ROOT), *sentence_breaches(ROOT), *translation_breaches(ROOT), *confusable_breaches(ROOT)]
    found += [f"sim-service/rosy_sim: {what}" for what in python_imports.breaches(ROOT / "sim-service" / "rosy_sim")]
    found += function_length_breaches(ROOT, files)
    looked = len(FOLDERS_WITH_README)
    for path in files:
        if path.suffix in {".png", ".wasm", ".woff2", ".ico"} or path == Path("scripts/borders.py"):
            continue
        looked += 1
        text = (ROOT / path).read_text(errors="replace")
        found += [f"{path}: {what}" for what in (*breaches(path, text), *robot_breaches(path, text))]
    for line in found:
        print(line)
    print(f"{looked - len(found)} passed, {len(found)} failed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
