"""
Makes the scripts importable as `./rosy test` runs them: from the scripts folder. Leaves out the tests of packages while they wait for their day.
"""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from testing.changes import packages_are_waiting

collect_ignore = ["test_package.py"] if packages_are_waiting(os.environ) else []
