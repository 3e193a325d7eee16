"""``python -m rosy_sim.lessons``: a rehearsal process; ``background_rehearsals`` starts it."""

from __future__ import annotations

import sys

from .rehearsal_process import main

sys.exit(main())
