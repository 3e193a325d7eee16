"""Programs as a person gives them: files, literate Haskell, inputs of a run."""

from __future__ import annotations

__all__: list[str] = []
