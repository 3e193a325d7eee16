"""``python -m rosy_sim.previews``: a preview process; ``preview_pool`` starts it."""

from __future__ import annotations

import sys

from .preview_process import main

sys.exit(main())
