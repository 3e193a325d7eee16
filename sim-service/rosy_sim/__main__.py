"""``python -m rosy_sim``: see ``cli``."""

from __future__ import annotations

import signal
import sys

# Ctrl-C while things are still being imported ends quietly; from then on each command ends as it should.
signal.signal(signal.SIGINT, signal.SIG_DFL)
from .cli import main  # noqa: E402

signal.signal(signal.SIGINT, signal.default_int_handler)
sys.exit(main())
