"""
Rectangles that cover the unknown cells of a grid: a robot must not enter what no scan has seen.

Rectangles may cover occupied cells, which makes them fewer, but free ones only where their number would be too large:
then the unknown area grows by a few cells until its outline is smooth enough.
"""

from __future__ import annotations

from typing import NamedTuple

from .occupancy import Occupancy, dilated

__all__ = ["CellRectangle", "unknown_areas"]

_MOST_GROWTH = 4
"""Cells by which an unknown area grows at most."""


class CellRectangle(NamedTuple):
    """Columns from ``left`` and rows from ``bottom`` up to, and without, ``right`` and ``top``."""

    left: int
    bottom: int
    right: int
    top: int

    def rows(self) -> range:
        """Its rows."""
        return range(self.bottom, self.top)

    def mask(self) -> int:
        """Its columns, a bit for each."""
        return (1 << self.right) - (1 << self.left)


def unknown_areas(grid: Occupancy, most: int) -> list[CellRectangle] | None:
    """At most ``most`` rectangles over all unknown cells; ``None`` if their outline is too ragged for so few."""
    unknown = grid.unknown()
    every = (1 << grid.width) - 1
    grown = unknown
    for _ in range(_MOST_GROWTH + 1):
        allowed = [every & (~free | more) for free, more in zip(grid.free, grown, strict=True)]
        found = _rectangles(unknown, allowed, most)
        if found is not None:
            return found
        grown = dilated(grown)
    return None


def _rectangles(needed: list[int], allowed: list[int], most: int) -> list[CellRectangle] | None:
    """Rectangles of allowed cells over all needed ones: from the lowest needed cell to the right, then up."""
    left = list(needed)
    found: list[CellRectangle] = []
    for y, cells in enumerate(allowed):
        while left[y]:
            if len(found) == most:
                return None
            start = (left[y] & -left[y]).bit_length() - 1
            beyond = ~cells >> start
            run = (beyond & -beyond) - 1 << start
            # No farther than the last needed cell of the run, in its row and above it.
            mask = (1 << (left[y] & run).bit_length()) - (1 << start)
            top = last = y
            while top < len(allowed) and allowed[top] & mask == mask:
                if left[top] & mask:
                    last = top
                    left[top] &= ~mask
                top += 1
            found.append(CellRectangle(start, y, mask.bit_length(), last + 1))
    return found
