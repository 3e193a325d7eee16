"""Recordings of runs on real robots."""
