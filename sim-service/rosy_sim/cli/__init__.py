"""
Command line of the service: ``serve``, ``node``, ``class``, ``run``, ``room``, ``replay``, ``check``, ``build``,
``lsp``.
``./rosy help COMMAND`` explains them.
"""

from .commands import main

__all__ = ["main"]
