"""Nodes of a Ray cluster: tests in many rooms and live classes on them. Ray has a lock file of its own."""
