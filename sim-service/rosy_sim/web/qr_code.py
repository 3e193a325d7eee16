"""
QR codes for a terminal: two modules in each character cell.
"""

from __future__ import annotations

import io

__all__ = ["qr_code_lines"]


def qr_code_lines(text: str) -> str:
    """The code as lines of half blocks; the colours of the terminal are inverted, so that it is dark on light."""
    # Imported for class mode alone.
    import segno

    lines = io.StringIO()
    segno.make(text, error="l", micro=False).terminal(lines, compact=True)
    return lines.getvalue().rstrip("\n")
