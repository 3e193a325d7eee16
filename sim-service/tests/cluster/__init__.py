"""Tests on a cluster of Ray nodes, all on this machine."""
