"""Gallery of worlds, as ``protocol/world.schema.json`` describes them."""

from __future__ import annotations

__all__: list[str] = []
