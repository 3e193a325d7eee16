"""
Explanations of a recorded run: why a command was sent, and why one was not (``why``, ``why_not``).

Pure functions over a ``RecordedRun``: no program, no world, no I/O. They say what the record holds and nothing else.
"""
