"""Export for a study: ProgSnap2 as its specification wants it, and nothing by which a pupil is recognised."""

from __future__ import annotations

import csv
import io
import json
import re
import zipfile
from datetime import datetime
from pathlib import Path

import msgspec
import pytest

from rosy_sim.classroom.exports.anonymous_source import anonymous_source, name_parts
from rosy_sim.classroom.exports.study_export import kept_key, new_key, write_study
from rosy_sim.classroom.exports.study_readme import README
from rosy_sim.classroom.messages.check_messages import CheckResult, Fault
from rosy_sim.classroom.store.class_store import ClassStore, Pupil
from rosy_sim.errors import BadInput

# ``progsnap2-v1.0.yaml`` of CSSPLICE/ProgSnapToolkit (commit 0007195): columns whose requirement is "Required"; the
# required columns of the events that we write; columns of all events; and the columns that only some events have.
REQUIRED = ("EventType", "EventID", "CodeStateID", "SubjectID", "ToolInstances")
OF_EVENT = {
    "File.Create": {"CodeStateSection"},
    "File.Edit": {"CodeStateSection", "EditType"},
    "Run.Program": {"ExecutionResult"},
    "Submit": set[str](),
}
OPTIONAL = {"Order", "ServerTimestamp", "AssignmentID", "ProblemID"}
SCORED = {"Run.Program", "Submit"}
METADATA = {
    "Version": ("1.0",),
    "IsEventOrderingConsistent": ("true", "false"),
    "EventOrderScope": ("Global", "Restricted", "None"),
    "EventOrderScopeColumns": ("",),
    "CodeStateRepresentation": ("Table", "Directory", "Git", "Keystroke"),
    "ProgramInputLinkTable": ("",),
}
# "Required columns can never be None; we use the empty string for some 'not present' values" (event_validator.py).
MAY_BE_EMPTY = {"ExecutionResult"}

Rows = list[dict[str, str]]


def table(archive: zipfile.ZipFile, name: str) -> Rows:
    return list(csv.DictReader(io.StringIO(archive.read(name).decode())))


def read_progsnap2(data: bytes) -> Rows:
    """The events of a data set, after a check against the specification."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        metadata = {row["Property"]: row["Value"] for row in table(archive, "DatasetMetadata.csv")}
        assert metadata.keys() == METADATA.keys()
        assert all(value in METADATA[name] for name, value in metadata.items())
        events = table(archive, "MainTable.csv")
        assert set(REQUIRED) <= events[0].keys()
        assert len({event["EventID"] for event in events}) == len(events)
        assert [int(event["Order"]) for event in events] == list(range(1, len(events) + 1))
        times = [datetime.strptime(event["ServerTimestamp"], "%Y-%m-%dT%H:%M:%S%z") for event in events]
        assert times == sorted(times)
        for event in events:
            needed = OF_EVENT[event["EventType"]]
            assert all(event[column] for column in {*REQUIRED, *needed} - MAY_BE_EMPTY)
            allowed = {*REQUIRED, *needed, *OPTIONAL} | ({"Score"} if event["EventType"] in SCORED else set())
            assert {column for column, value in event.items() if value} <= allowed
            assert event["EditType"] in ("", "GenericEdit")
            assert event["Score"] == "" or 0 <= float(event["Score"]) <= 1
            # Directory: a folder for each CodeStateID, with the files of that state.
            folder = f"CodeStates/{event['CodeStateID']}/"
            (file,) = (name for name in archive.namelist() if name.startswith(folder))
            assert event["CodeStateSection"] in ("", file.removeprefix(folder))
        subjects = {event["SubjectID"] for event in events}
        assert {row["SubjectID"] for row in table(archive, "LinkTables/LinkSubjectProblem.csv")} <= subjects
    return events


def project(haskell: str, room: str = "lesson bump") -> str:
    return json.dumps({"rosy": 1, "name": "Ada's walk", "haskell": haskell, "world": {"name": room}})


def join(store: ClassStore, nickname: str, words: str) -> Pupil:
    pupil = store.join(nickname, lambda: words, nickname, 0.0)
    assert isinstance(pupil, Pupil)
    return pupil


def save(store: ClassStore, pupil: Pupil, text: str, at: float, program: str = "p") -> None:
    base = latest.number if (latest := store.latest(pupil.id, program)) is not None else 0
    store.save(pupil.id, program, "Ada's walk", text, "change", base, str(at), [], at)


def exported(store: ClassStore, key: bytes | None = None) -> bytes:
    target = io.BytesIO()
    write_study(store, target, new_key() if key is None else key, {"bump", "drive"})
    return target.getvalue()


def everything(data: bytes) -> str:
    """All names of files and all contents."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return "\n".join([*archive.namelist(), *(archive.read(name).decode() for name in archive.namelist())])


@pytest.fixture
def studied(store: ClassStore) -> ClassStore:
    """Ada and Ben take part, Cleo does not, and Dan has not answered."""
    ada, ben = join(store, "Ada", "apple boat star"), join(store, "Ben Ö.", "cloud tree fox")
    cleo, dan = join(store, "Cleo", "green lamp owl"), join(store, "Dan", "sun road hat")
    save(store, ada, project("main = simulate 1"), 5.0)
    store.study.begin("Prof. Quirk", 10.0)
    for pupil, since in ((ada, 20.0), (ben, 30.0), (cleo, 0.0)):
        store.study.answer(pupil.id, since)
    words = """-- by Ada
adaDrives = 1
main = simulate (adaDrives, say "Ben Ö. 220", appleBoatStar)
appleBoatStar = 2"""
    save(store, ada, project(words), 40.0)
    save(store, ada, project(words.replace("by Ada", "by me")), 41.0)
    save(store, ada, project("main = simulate 3"), 42.0)
    for pupil in (ben, cleo, dan):
        save(store, pupil, project("main = simulate 4", "lesson ada-was-here"), 25.0)
        save(store, pupil, project("main = simulate 5", "lesson ada-was-here"), 43.0)
    latest = store.latest(ada.id, "p")
    assert latest is not None
    store.study.add_run(latest.number, 44.0)
    task = store.tasks.open("Task of Ada", None, 0.0)
    assert task is not None
    for pupil, at in ((ada, 45.0), (ben, 29.0), (cleo, 45.0)):
        store.tasks.hand_in(task.id, pupil.id, "Ada's walk", project("main = simulate 3"), at, "", "bump")
    result = CheckResult(46.0, "maze", 4, 1, 20.0, "", passed=3)
    store.tasks.grade(task.id, ada.id, 45.0, msgspec.json.encode(result))
    for lesson, begun in (("bump", 50.0), ("own lesson of Ada", 50.0), ("ada", 50.0), ("drive", 15.0)):
        store.progress.add(ada.id, lesson, "Title", 5, ["a", "b"], begun)
    return store


def test_the_export_is_read_as_progsnap2(studied: ClassStore) -> None:
    events = read_progsnap2(exported(studied))
    assert [(event["EventType"], event["ServerTimestamp"][17:19], event["ProblemID"]) for event in events] == [
        ("File.Edit", "40", "bump"),
        # The change in between was one of a comment.
        ("File.Edit", "42", "bump"),
        ("File.Edit", "43", ""),
        ("Run.Program", "44", "bump"),
        ("Submit", "45", "bump"),
    ]
    assert len({event["SubjectID"] for event in events}) == 2
    assert (events[-1]["AssignmentID"], events[-1]["Score"]) == ("assignment-1", "0.750")
    # A program that runs is the state that was saved.
    assert events[1]["CodeStateID"] == events[3]["CodeStateID"] != events[0]["CodeStateID"]


def test_a_program_is_created_once(studied: ClassStore) -> None:
    ada = studied.pupils()[0]
    save(studied, ada, project("main = simulate 7"), 60.0, "q")
    save(studied, ada, project("main = simulate 8"), 61.0, "q")
    kinds = [(event["EventType"], event["CodeStateSection"]) for event in read_progsnap2(exported(studied))]
    assert kinds[-2:] == [("File.Create", "program-2.hs"), ("File.Edit", "program-2.hs")]


def test_no_name_and_no_word_of_a_pupil_is_in_the_export(studied: ClassStore) -> None:
    # The words of the format and of its description.
    # Always the same pseudonyms: the hexadecimal digits of random ones may spell a short name.
    text = everything(exported(studied, bytes(32))).replace(README, "").casefold()
    text = re.sub(r"readme\.md|datasetmetadata", "", text)
    assert "simulate" in text
    for word in ("ada", "ben ", "ö", "cleo", "dan", "apple", "boat", "task of", "prof", "quirk", "walk", "own lesson"):
        assert word not in text, word


def test_only_what_pupils_who_take_part_did_since_then_is_exported(studied: ClassStore) -> None:
    text = everything(exported(studied))
    for source in ("simulate 1", "simulate 4"):
        assert source not in text
    assert text.count("simulate 5") == 1
    with zipfile.ZipFile(io.BytesIO(exported(studied))) as archive:
        lessons = table(archive, "LinkTables/LinkSubjectProblem.csv")
    assert [(row["ProblemID"], row["X-StepsDone"], row["X-Steps"]) for row in lessons] == [("bump", "2", "5")]


@pytest.mark.parametrize(
    ("fault", "score"), [("compile", "0.000"), ("room", ""), ("time", ""), ("lost", ""), ("lesson", "")]
)
def test_a_check_that_could_not_be_made_gives_no_score(studied: ClassStore, fault: Fault, score: str) -> None:
    result = CheckResult(47.0, "maze", 4, 1, 20.0, "", fault=fault)
    studied.tasks.grade(1, studied.pupils()[0].id, 45.0, msgspec.json.encode(result))
    assert read_progsnap2(exported(studied))[-1]["Score"] == score


@pytest.mark.parametrize(
    ("merged", "into", "since"),
    [("Ada", "Ben Ö.", 30), ("Ben Ö.", "Ada", 30), ("Ada", "Cleo", 0), ("Cleo", "Ada", 0), ("Dan", "Ada", 20)],
)
def test_a_merged_pupil_takes_part_only_as_both_entries_agreed(
    studied: ClassStore, merged: str, into: str, since: int
) -> None:
    pupils = {pupil.nickname: pupil.id for pupil in studied.pupils()}
    studied.roster.merge(pupils[merged], pupils[into], 50.0)
    assert studied.study.answers()[pupils[into]] == since
    assert (studied.study.runs(pupils[into]) == []) == (since == 0)


def test_pseudonyms_are_others_in_each_export_unless_a_key_is_kept(studied: ClassStore, tmp_path: Path) -> None:
    def subjects(key: bytes | None = None) -> set[str]:
        return {event["SubjectID"] for event in read_progsnap2(exported(studied, key))}

    assert subjects().isdisjoint(subjects())
    key = kept_key(tmp_path / "key")
    assert (tmp_path / "key").stat().st_mode & 0o777 == 0o600
    assert subjects(key) == subjects(kept_key(tmp_path / "key"))
    (tmp_path / "key").write_text("none\n")
    with pytest.raises(BadInput, match="has no key"):
        kept_key(tmp_path / "key")


def test_nothing_is_exported_without_a_study_and_without_pupils_who_take_part(store: ClassStore) -> None:
    ada = join(store, "Ada", "apple boat star")
    save(store, ada, project("main = simulate 1"), 5.0)
    with pytest.raises(BadInput, match="takes part in no study"):
        exported(store)
    store.study.begin("Prof. Quirk", 1.0)
    with pytest.raises(BadInput, match="No pupil has agreed"):
        exported(store)
    store.study.answer(ada.id, 2.0)
    assert len(read_progsnap2(exported(store))) == 1


def test_the_end_of_a_study_forgets_answers_and_runs(studied: ClassStore) -> None:
    ada = studied.pupils()[0]
    assert studied.study.runs(ada.id)
    studied.study.answer(ada.id, 0.0)
    assert studied.study.runs(ada.id) == []
    studied.study.end()
    assert (studied.study.study(), studied.study.answers()) == (None, {})
    assert len(studied.history(ada.id)) == 4


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ('say "Ada \\"A\\" 22\\n" -- Ada', 'say "xxx \\"x\\" 22\\n"'),
        ('a = "Ad\\\n   \\a" ++ b {- Ada {- Ada -} -}', 'a = "xxx" ++ b'),
        ("adaRuns :: Ada -> Ada\nadaRuns x_ada = x_ada", "name1 :: Ada -> Ada\nname1 name2 = name2"),
        ("data Mode = Ada | Ben\nf Ada = 1", "data Mode = Name1 | Ben\nf Name1 = 1"),
        ("f x = case x of\n  Just ada -> ada + 1", "f x = case x of\n  Just name1 -> name1 + 1"),
        ("éda = 1\nfade = adaptive", "éda = 1\nfade = adaptive"),
    ],
)
def test_words_of_pupils_leave_a_program(source: str, expected: str) -> None:
    assert anonymous_source(source, name_parts(["Ada"])) == f"{expected}\n"


def test_a_name_of_the_library_stays_where_a_pupil_is_called_like_it() -> None:
    source = "maxRun = 1\nmain = simulate (max maxRun 2)"
    assert anonymous_source(source, name_parts(["Max"])) == "name1 = 1\nmain = simulate (max name1 2)\n"
