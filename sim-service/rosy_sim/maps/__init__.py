"""Rooms from maps of ROS: ``map_server``'s files, outlines of what is occupied in them, the command ``room``."""

from __future__ import annotations
