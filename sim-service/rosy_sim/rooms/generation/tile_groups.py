"""Groups of tiles of one kind that stand free on the floor of a room: pits and blocks, but not its outer walls."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

__all__ = ["Group", "inner_groups", "with_groups"]

Group = frozenset[tuple[int, int]]
"""Tiles that touch by their sides, each as row (from the top) and column."""


def inner_groups(tiles: Sequence[str]) -> list[Group]:
    """The groups that do not touch the edge of the room, from the top left."""
    seen: set[tuple[int, int]] = set()
    found: list[Group] = []
    for row, line in enumerate(tiles):
        for column, char in enumerate(line):
            if char == "." or (row, column) in seen:
                continue
            group = _connected(tiles, row, column)
            seen |= group
            if not any(_is_edge(tiles, *tile) for tile in group):
                found.append(group)
    return found


def with_groups(tiles: Sequence[str], groups: Iterable[Group]) -> list[str]:
    """
    The tiles with these groups in place of those of ``inner_groups``, one for one.

    Tiles of a group that would lie on the edge of the room are left out.
    """
    rows = [list(line) for line in tiles]
    pairs = list(zip(inner_groups(tiles), groups, strict=True))
    kinds = [tiles[row][column] for group, _ in pairs for row, column in [min(group)]]
    for group, _ in pairs:
        for row, column in group:
            rows[row][column] = "."
    for (_, group), kind in zip(pairs, kinds, strict=True):
        for row, column in group:
            if 0 <= row < len(rows) and 0 <= column < len(rows[0]) and not _is_edge(tiles, row, column):
                rows[row][column] = kind
    return ["".join(row) for row in rows]


def _is_edge(tiles: Sequence[str], row: int, column: int) -> bool:
    return row in (0, len(tiles) - 1) or column in (0, len(tiles[0]) - 1)


def _connected(tiles: Sequence[str], row: int, column: int) -> Group:
    kind = tiles[row][column]
    group = {(row, column)}
    front = [(row, column)]
    while front:
        i, j = front.pop()
        for tile in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            inside = 0 <= tile[0] < len(tiles) and 0 <= tile[1] < len(tiles[0])
            if inside and tile not in group and tiles[tile[0]][tile[1]] == kind:
                group.add(tile)
                front.append(tile)
    return frozenset(group)
