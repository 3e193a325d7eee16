"""``README.md`` of a study's export, in English: what its events and columns mean."""

from __future__ import annotations

__all__ = ["README"]

README = """\
# A class of Rosy, in ProgSnap2 1.0

MainTable.csv has an event in each row, DatasetMetadata.csv says how to read it, and CodeStates has a folder for each
CodeStateID. LinkTables/LinkSubjectProblem.csv says how many steps of each lesson each pupil has done.

- File.Create, File.Edit: a program was saved with another text, two seconds after a change or at a run. EditType is
  GenericEdit: an event has all changes since the one before.
- Run.Program: a program was run. How it ended is not stored, so ExecutionResult is empty.
- Submit: the newest program that a pupil handed in for an assignment. Score is the part of the rooms in which the
  newest check of the teacher found that it did well: 0 if it does not compile, and empty without a check or if the
  check could not be made. Earlier ones are not stored.

A CodeState is the one program that the event is about; its file name tells the programs of a pupil apart. ProblemID is
the lesson of Rosy in whose room the program is. Comments are left out of the programs, letters of texts in quotes are
x, and names that contain a name of a pupil are name1, name2 and so on. A class keeps at most 300 versions of each
program, the newest ones. Times are those of the computer that serves the class, in UTC.

Only pupils who take part are here, and of them only what happened since they do.
"""
