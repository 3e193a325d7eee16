"""Nodes of a Ray cluster, all on this machine, where Ray is installed."""

from __future__ import annotations

import pytest

from rosy_sim.bench.cluster.local_nodes import CLUSTER_PYTHON, Node

__all__ = ["CLUSTER_PYTHON", "Node", "needs_ray"]

needs_ray = pytest.mark.skipif(
    not CLUSTER_PYTHON.exists(), reason="cluster: Ray is not installed; ./rosy start --cluster installs it"
)
