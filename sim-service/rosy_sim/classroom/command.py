"""
Command ``./rosy class``: lists, exports, deletes and restores classes. ``marks`` is in ``written_tests``, ``study`` in
``study_export``.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from ..atomic_file import AtomicFile
from ..errors import BadInput
from ..lessons.catalogue import lesson_names
from ..sentences.sentence import Sentence, tr
from ..sentences.terminal_text import neutralize_line
from ..sentences.wording import in_terminal
from .exports.class_export import write_export
from .exports.study_export import kept_key, new_key, write_study
from .store.class_places import ClassPlace, remove_expired
from .store.database import DeletedClass
from .store.retention import kept_until

__all__ = ["add_class_options", "deleted_sentence", "run_class_command"]


def add_class_options(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("action", choices=("list", "export", "delete", "restore", "marks", "study"))
    parser.add_argument("name", nargs="?")
    parser.add_argument("-o", dest="output", type=Path, metavar="FILE")
    parser.add_argument("--yes", action="store_true")
    parser.add_argument("--forever", action="store_true")
    parser.add_argument("--key", type=Path, metavar="FILE")
    parser.add_argument("--as", dest="new_name", metavar="NAME")


def run_class_command(
    place: ClassPlace,
    options: argparse.Namespace,
    now: float,
    output: Callable[[str], None],
    answer: Callable[[], str | None],
    examples: Path,
) -> int:
    """
    Run the command; returns the exit status.

    Args:
        now: the time, s since 1970.
        examples: the folder of the examples, with the lessons.
        answer: the line that a person types; ``None`` when no person is at a terminal.

    Raises:
        BadInput: there is no such class, or it is in use, or the file cannot be written.
    """
    if options.action not in ("export", "study") and options.output is not None:
        raise BadInput(tr("-o is for export, study and marks: the file to write."))
    if options.action != "study" and options.key is not None:
        raise BadInput(tr("--key is for study: the file with the key of the pseudonyms."))
    if options.action != "delete" and (options.yes or options.forever):
        raise BadInput(tr("--yes and --forever are for delete."))
    if options.action != "restore" and options.new_name is not None:
        raise BadInput(tr("--as is for restore: the name of the restored class."))
    remove_expired(place, now)

    def say(sentence: Sentence) -> None:
        output(in_terminal(sentence))

    if options.action == "list":
        for name in place.names():
            output(name)
        for deleted in place.deleted():
            say(deleted_sentence(deleted))
        return 0
    if options.action == "delete":
        return _delete(place, options, now, say, answer)
    if options.action == "restore":
        deleted = _chosen_deleted(place, options.name)
        name = options.new_name or deleted.name
        place.restore(deleted, name)
        say(tr("The class {name} is back.", name=name))
        return 0
    name = _chosen(place, options.name)
    if options.action == "study":
        target = options.output or Path(f"{name}-study.zip")
        key = new_key() if options.key is None else kept_key(options.key)
        with place.read(name) as store, AtomicFile(target, mode=0o600) as file:
            pupils = write_study(store, file, key, lesson_names(examples / "lessons"))
        say(tr("{file}: {pupils} pupils.", file=neutralize_line(str(target)), pupils=pupils))
        return 0
    target = options.output or Path(f"{name}.zip")
    with place.read(name) as store, AtomicFile(target, mode=0o600) as file:
        programs = write_export(store, file)
        pupils = len(store.pupils())
    file_name = neutralize_line(str(target))
    say(tr("{file}: {pupils} pupils, {programs} programs.", file=file_name, pupils=pupils, programs=programs))
    return 0


def _delete(
    place: ClassPlace,
    options: argparse.Namespace,
    now: float,
    say: Callable[[Sentence], None],
    answer: Callable[[], str | None],
) -> int:
    name = options.name
    if name is None:
        raise BadInput(tr("Which class is to be deleted? Say its name; ./rosy class list names them."))
    older = [deleted for deleted in place.deleted() if deleted.name == name] if options.forever else []
    if exists := not older or name in place.names():
        with place.read(name) as store:
            pupils = store.pupils()
            programs = sum(len(store.programs(pupil.id)) for pupil in pupils)
            handed_in = sum(len(store.tasks.kept(task.id)) for task in store.tasks.tasks())
        say(
            tr(
                "The class {name} has {pupils} pupils, {programs} programs and {handIns} programs that were handed in.",
                name=name,
                pupils=len(pupils),
                programs=programs,
                handIns=handed_in,
            )
        )
    if options.forever:
        say(tr("Nothing of it can be restored afterwards."))
    else:
        say(tr("It can be restored until {date}.", date=_last_day(now, None)))
    if not options.yes:
        say(tr("Type the name of the class to delete it:"))
        typed = answer()
        if typed is None:
            raise BadInput(
                tr("No person is at this terminal to confirm that; --yes deletes the class without a question.")
            )
        if typed.strip() != name:
            raise BadInput(tr("That is not {name}: nothing was deleted.", name=name))
    if exists:
        place.delete(name, now)
    if options.forever:
        for deleted in place.deleted():
            if deleted.name == name:
                place.remove(deleted)
        say(tr("The class {name} is deleted for good.", name=name))
        return 0
    say(tr("The class {name} is deleted. ./rosy class restore {name} brings it back.", name=name))
    return 0


def deleted_sentence(deleted: DeletedClass) -> Sentence:
    """Until when a deleted class can be restored, or after which day the next start removes it."""
    date = _last_day(deleted.at, deleted.announced)
    if deleted.announced is None:
        return tr("{name} (deleted; can be restored until {date})", name=deleted.name, date=date)
    return tr("{name} (deleted; a start after {date} removes it for good)", name=deleted.name, date=date)


def _last_day(deleted: float, announced: float | None) -> str:
    """The last whole day on which a class that was deleted then can be restored for certain."""
    return _day(kept_until(deleted, announced))


def _day(time: float) -> str:
    return datetime.fromtimestamp(time, UTC).date().isoformat()


def _chosen(place: ClassPlace, name: str | None) -> str:
    """The named class, or the only one that there is."""
    if name is not None:
        return name
    names = place.names()
    if not names:
        raise BadInput(tr("There is no class yet; ./rosy start --class begins one."))
    if len(names) > 1:
        raise BadInput(tr("Which class? There are {names}.", names=list(names)))
    return names[0]


def _chosen_deleted(place: ClassPlace, name: str | None) -> DeletedClass:
    """The deleted class of that name that was deleted last, or the only deleted class."""
    found = [deleted for deleted in place.deleted() if name is None or deleted.name == name]
    if not found:
        raise BadInput(tr("There is no deleted class to restore; ./rosy class list names those that can be restored."))
    names = sorted({deleted.name for deleted in found})
    if len(names) > 1:
        raise BadInput(tr("Which class? There are {names}.", names=names))
    return found[0]
