"""
Number of cases and seed of random tests: ``./rosy test`` draws the same ones for the same commit,
``./rosy test nightly`` more of them from a new seed, which it prints.
"""

from __future__ import annotations

import os

__all__ = ["NIGHTLY", "SEED"]

NIGHTLY = os.environ.get("ROSY_TEST_NIGHTLY") == "1"
"""Whether random tests draw more cases than in an ordinary run."""

SEED = int(os.environ.get("ROSY_TEST_SEED", "1"))
"""Seed of the random tests."""
