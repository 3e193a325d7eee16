"""``python -m rosy_sim.rooms``: a trial process; ``trial_pool`` starts it."""

from __future__ import annotations

import sys

from .trial_process import main

sys.exit(main())
