"""
Class mode: the store of a class, its pupils and their programs, and the state of a lesson in progress. No web server.
"""

from __future__ import annotations
