"""Tests of a program in many generated rooms: families of rooms, trials on all cores, the smallest failing room."""

from __future__ import annotations
