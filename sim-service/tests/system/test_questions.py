"""
Questions about runs of the examples, each with the sentences of its answer: ``questions.md``.

Each example runs with the real worker in its own world, as on the page, and the page's question is answered. Hands are
lines of ``./rosy run --input``, behind ``hands:``. ``UPDATE_GOLDENS=1`` writes the answers anew.
"""

from __future__ import annotations

import os
import re
import socket
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from rosy_sim.config import discover
from rosy_sim.explain.function_types import written_memories
from rosy_sim.explain.why_not import RobotLimits
from rosy_sim.explain.wording import english
from rosy_sim.run.headless_run import RunOutput, RunSettings, run_over_link
from rosy_sim.run.steps.lockstep import Lockstep
from rosy_sim.web.sessions.run_explanations import RunExplanations
from rosy_sim.wire import page
from rosy_sim.wire.firing import Branch, read_firings
from rosy_sim.wire.worker import Started
from rosy_sim.worker.blocking_worker import BlockingWorker
from rosy_sim.world.events import Lift, Press, Teleport, UserAction
from rosy_sim.world.field_readers import Pose
from rosy_sim.worlds.gallery import named_world, usable_world

from .real_runs import LIMITS, program, worker_started

pytestmark = [pytest.mark.real, pytest.mark.skipif(not discover().worker, reason="the worker is not built")]

TABLE = Path(__file__).with_name("questions.md")

NUMBER = r"(\d+(?:\.\d+)?)"
Found = re.Match[str]

QUESTIONS: dict[str, Callable[[Found], page.Why | page.WhyNot]] = {
    rf"Why does the robot move like this at {NUMBER} s\?": lambda f: page.Why(1, float(f[1]), command="Velocity"),
    rf"Why is the robot there at {NUMBER} s\?": lambda f: page.Why(1, float(f[1]), position=True),
    rf"Why `(\w+)` at {NUMBER} s\?": lambda f: page.Why(1, float(f[2]), command=f[1]),
    rf"Why does `(Memory [^`]+)` have its value at {NUMBER} s\?": lambda f: page.Why(1, float(f[2]), memory=f[1]),
    rf"What happened with `([^`]+)` by {NUMBER} s\?": lambda f: page.Why(1, float(f[2]), event=f[1]),
    rf"Why did \*\*(\w+)\*\* not run from {NUMBER} s to {NUMBER} s\?": lambda f: page.WhyNot(
        1, float(f[2]), float(f[3]), function=f[1]
    ),
    rf"Why did \*\*(\w+)\*\* send no `([^`]+)` from {NUMBER} s to {NUMBER} s\?": lambda f: page.WhyNot(
        1, float(f[3]), float(f[4]), function=f[1], command=f[2]
    ),
    rf"Why no `([^`]+)` from {NUMBER} s to {NUMBER} s\?": lambda f: page.WhyNot(
        1, float(f[2]), float(f[3]), command=f[1]
    ),
    rf"Why was no `([^`]+)` received by {NUMBER} s\?": lambda f: page.WhyNot(1, 0.0, float(f[2]), event=f[1]),
}
"""How a question is written, and what the page sends. That of a firing is about the latest one of a function."""

CASE = rf"Why not the case `([^`]+)` of \*\*(\w+)\*\* from {NUMBER} s to {NUMBER} s\?"
"""About a branch by what it is told by, and the innermost definition around it."""

FIRING = rf"Why did \*\*(\w+)\*\* run at {NUMBER} s\?"

HANDS: dict[str, Callable[[Found], UserAction]] = {
    rf"{NUMBER} s press (\d)": lambda f: Press(int(f[2]), True),
    rf"{NUMBER} s release (\d)": lambda f: Press(int(f[2]), False),
    rf"{NUMBER} s lift": lambda _: Lift("both", True),
    rf"{NUMBER} s lower": lambda _: Lift("both", False),
    rf"{NUMBER} s put at {NUMBER} {NUMBER}": lambda f: Teleport(Pose(float(f[2]), float(f[3]), 0.0)),
}


@dataclass
class Section:
    """A run with its questions, each with the sentences of its answer."""

    title: str
    example: str
    seconds: float
    hands: tuple[tuple[float, UserAction], ...]
    questions: list[tuple[str, list[str]]] = field(default_factory=list)


def read_table(text: str) -> tuple[str, list[Section]]:
    """The text before the first section, and the sections."""
    head, *parts = re.split(r"^## ", text, flags=re.MULTILINE)
    return head, [_section(part) for part in parts]


def _section(text: str) -> Section:
    title, *lines = text.strip().splitlines()
    found = re.fullmatch(rf"(\w+), {NUMBER} s(?:, hands: (.*))?", title)
    assert found is not None, title
    hands = tuple(_hand(one) for one in found[3].split(", ")) if found[3] else ()
    section = Section(title, found[1], float(found[2]), hands)
    for line in lines:
        if line.startswith("- "):
            section.questions[-1][1].append(line[2:])
        elif line:
            section.questions.append((line, []))
    return section


def _hand(text: str) -> tuple[float, UserAction]:
    [(made, found)] = [(made, found) for form, made in HANDS.items() if (found := re.fullmatch(form, text))]
    return float(found[1]), made(found)


TEXT, SECTIONS = read_table(TABLE.read_text("utf-8"))


@pytest.fixture(scope="module")
def worker() -> Iterator[BlockingWorker]:
    yield from worker_started()


class Asked:
    """A run of an example that answers questions."""

    def __init__(self, worker: BlockingWorker, section: Section) -> None:
        source, world = program(section.example)
        self._answers: list[page.Because] = []
        self._explanations = RunExplanations(self._answers.append)
        checked = worker.check(source)
        # Questions name memories as the program writes their types, a request as the run tells them.
        self._memories = {name: spelled for spelled, name in written_memories(checked.graph).items()}
        self._explanations.on_checked(source, checked)
        place = usable_world(named_world(world), "world", 1)
        self._explanations.start(1, source, RobotLimits.of_motors(place.robot.limits))
        self._firings: list[tuple[float, str, int]] = []
        self._branches: list[Branch] = []
        settings = RunSettings(section.seconds, 1, None, section.hands, LIMITS)
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        with ours:
            started = worker.run(source, theirs)
            assert isinstance(started, Started)
            self._branches = started.branches
            self._explanations.on_branches(started.branches)
            output = RunOutput(observe=self._observe, provenance=True)
            outcome = run_over_link(ours, place, settings, output, worker)
        assert outcome.ended in ("time", "done")

    def _observe(self, lockstep: Lockstep) -> None:
        self._explanations.on_step(lockstep)
        done = lockstep.settled or lockstep.ended
        assert done is not None
        self._firings += [(lockstep.time, firing.function, firing.n) for firing in read_firings(done.firings)]

    def answer(self, question: str) -> list[str]:
        """The sentences of the answer."""
        self._explanations.answer(self._request(question))
        return [english(one.said) for one in self._answers.pop().sentences]

    def _request(self, question: str) -> page.Why | page.WhyNot:
        firing = re.fullmatch(FIRING, question)
        if firing is not None:
            numbers = [n for time, name, n in self._firings if name == firing[1] and time <= float(firing[2]) + 0.03]
            return page.Why(1, firing=numbers[-1])
        case = re.fullmatch(CASE, question)
        if case is not None:
            found = next(one for one in self._branches if (one.text, one.definitions[-1]) == (case[1], case[2]))
            return page.WhyNot(1, float(case[3]), float(case[4]), branch=page.BranchPlace(found.start, found.end))
        [(made, match)] = [(made, match) for form, made in QUESTIONS.items() if (match := re.fullmatch(form, question))]
        request = made(match)
        if isinstance(request, page.Why):
            request.memory = self._memories.get(request.memory, request.memory)
        return request


@pytest.mark.parametrize("section", SECTIONS, ids=[section.title for section in SECTIONS])
def test_the_answers_are(section: Section, worker: BlockingWorker) -> None:
    run = Asked(worker, section)
    answers = [(question, run.answer(question)) for question, _ in section.questions]
    if os.environ.get("UPDATE_GOLDENS") == "1":
        section.questions = answers
        TABLE.write_text(TEXT + "\n".join(_written(one) for one in SECTIONS), "utf-8")
    assert answers == section.questions


def _written(section: Section) -> str:
    blocks = ["\n".join([question, *(f"- {one}" for one in answer)]) for question, answer in section.questions]
    return "\n\n".join([f"## {section.title}", *blocks]) + "\n"


def test_there_are_sixty_questions_about_all_examples() -> None:
    asked = [question for section in SECTIONS for question, _ in section.questions]
    assert len(asked) == len({(s.title, q) for s in SECTIONS for q, _ in s.questions}) >= 60
    with_program = {path.parent.name for path in discover().examples.glob("*/program.rosy")}
    assert {section.example for section in SECTIONS} == with_program
    for form in [*QUESTIONS, FIRING, CASE]:
        assert any(re.fullmatch(form, question) for question in asked), form
