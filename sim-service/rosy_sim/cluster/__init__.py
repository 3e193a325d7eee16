"""Nodes of a Ray cluster, and tests in many rooms on them. Ray has its own lock file; only ``trials`` imports it."""
