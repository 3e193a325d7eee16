"""Sentences that users read: templates with arguments, their wording in each language, and text made safe to print."""

from __future__ import annotations

__all__: list[str] = []
