"""
A new language by the recipe of CONTRIBUTING.md, in a copy of the parts that it touches: a folder and a line.

The language is German under another tag. Its tables are read by the generator, the service, the shell, codegen and the page; what it lacks is
listed, or is in English.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

COPIED = (
    "codegen/src",
    "editor/src",
    "editor/plugins",
    "examples",
    "languages",
    "protocol/robots",
    "rosy-hs/app",
    "rosy-hs/robots",
    "rosy-hs/ros/msg",
    "rosy-hs/src",
    "rosy-hs/worker",
    "rosy-hs/LANGUAGE.md",
    "scripts",
    "sim-service/rosy_sim",
    "docs",
    "rosy",
)

PAGE = """
import {speakAsTerminal} from "./codegen/src/terminal_language.ts"
import {words as blocks} from "./codegen/src/words/index.ts"
import {readLessons} from "./editor/plugins/guide/lesson_source.ts"
import {paperBlocks} from "./editor/plugins/guide/toolbox_blocks.ts"
import {guideWords} from "./editor/src/guide/guide_words.ts"
import {languageFor, languages, loadLanguage} from "./editor/src/words/language_choice.ts"
import {words} from "./editor/src/words/index.ts"

const root = {lang: "", dir: ""}
Object.assign(globalThis, {document: {documentElement: root}})
const language = languageFor("", null, ["it-CH"])
await loadLanguage(language)
speakAsTerminal({LANG: "it_IT.UTF-8"})
console.log(JSON.stringify({
  language,
  menu: languages[language],
  run: words.run,
  command: blocks.commandLine.cannotRead("p"),
  guide: guideWords("it").skip,
  paper: paperBlocks("it")[0]?.name,
  lesson: readLessons(".")[0]?.texts("it").title,
}))
"""


def run(copy: Path, *command: str, **environment: str) -> subprocess.CompletedProcess[str]:
    variables = {**os.environ, "ROSY_ROOT": str(copy), "PYTHONPATH": f"{copy}/sim-service:{copy}/scripts", **environment}
    return subprocess.run(command, cwd=copy, env=variables, capture_output=True, text=True)


def breaches(copy: Path) -> list[str]:
    """What the checks of languages say."""
    code = "from pathlib import Path; from languages import *; from sentences import sentence_breaches; from robot_typescript import label_breaches\n"
    code += "print(*language_breaches(Path()), *sentence_breaches(Path()), *label_breaches(), sep='\\n')"
    done = run(copy, sys.executable, "-c", code)
    assert done.returncode == 0, done.stderr
    return [line for line in done.stdout.splitlines() if "/it" in line]


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The repository with Italian, whose words are German."""
    here = tmp_path_factory.mktemp("language")
    for part in COPIED:
        if (ROOT / part).is_file():
            (here / part).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / part, here / part)
        else:
            shutil.copytree(ROOT / part, here / part, ignore=shutil.ignore_patterns("__pycache__", "tests", "*.png", "*.gif"))
    (here / "node_modules").symlink_to(ROOT / "node_modules")
    shutil.copytree(here / "languages/de", here / "languages/it")
    assert breaches(here)[0] == "languages/it: has no line in languages/languages.json, and the page does not offer it"
    registry = here / "languages/languages.json"
    registry.write_text(registry.read_text().replace('"en": "English"', '"en": "English", "it": "Italiano"'))
    done = run(here, sys.executable, "scripts/robots.py")
    assert done.returncode == 0, done.stdout + done.stderr
    return here


def test_a_folder_and_a_line_make_a_language(copy: Path) -> None:
    (only,) = breaches(copy)
    assert only.startswith("languages/it/robot_labels.json: these have English labels: ")
    changed = run(copy, "git", "diff", "--no-index", "--name-only", str(ROOT / "languages"), "languages").stdout.split()
    assert {str(Path(name).relative_to("languages")).split("/")[0] for name in changed if name.startswith("languages")} <= {"it", "languages.json"}


def test_its_words_are_found_by_page_guide_blocks_and_lessons(copy: Path) -> None:
    (copy / "page.ts").write_text(PAGE)
    done = run(copy, str(ROOT / "node_modules/.bin/vite-node"), "page.ts")
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(done.stdout.splitlines()[-1])
    assert found == {
        "language": "it",
        "menu": "Italiano",
        "run": "Start",
        "command": "p lässt sich nicht lesen.",
        "guide": "Zum Text",
        "paper": "Fertiges",
        # Lessons that are not translated are in English.
        "lesson": "Hello, robot",
    }


def test_its_sentences_and_help_are_found_by_service_and_shell(copy: Path) -> None:
    code = "from rosy_sim.sentences.wording import in_terminal; from rosy_sim.sentences.sentence import tr; from rosy_sim.classroom.word_list import *\n"
    code += "print(in_terminal(tr('expected one argument')), word_list('it') == word_list('de'))"
    assert run(copy, sys.executable, "-c", code, LC_ALL="it_IT.UTF-8").stdout == "erwartet ein Argument True\n"
    assert run(copy, "./rosy", "help", LC_ALL="it_IT.UTF-8").stdout == (ROOT / "languages/de/help/commands.txt").read_text()


def test_what_a_language_lacks_is_listed(copy: Path) -> None:
    table = copy / "languages/it/sentences.json"
    whole = table.read_text()
    sentences = json.loads(whole)
    del sentences["sentences"]["expected one argument"]
    table.write_text(json.dumps(sentences, indent=2, ensure_ascii=False) + "\n")
    for part in ("help/run.txt", "pupil_words.txt"):
        (copy / "languages/it" / part).rename(copy / part.replace("/", "-"))
    try:
        listed = "\n".join(breaches(copy))
    finally:
        table.write_text(whole)
        for part in ("help/run.txt", "pupil_words.txt"):
            (copy / part.replace("/", "-")).rename(copy / "languages/it" / part)
    assert "languages/it/pupil_words.txt: is missing" in listed
    assert "languages/it/help/run.txt: there is no such page" in listed
    assert "languages/it/sentences.json: nothing is said for “expected one argument”" in listed
