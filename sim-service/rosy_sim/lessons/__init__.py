"""
Lessons: their files, and the checks that decide whether a step of a lesson is done.

``checks`` are the kinds of checks as values; ``verdicts`` judges them by a recorded run (``recording``) and by the
typed graph of the program (``program_graph``); ``lesson_watch`` does so while a run goes on. These are pure.
``lesson_file`` and ``catalogue`` read folders of ``examples/lessons``, ``rehearsal`` runs an attempt headless, and
``background_rehearsals`` those of a lesson that is being written, in a ``rehearsal_process``.
"""
