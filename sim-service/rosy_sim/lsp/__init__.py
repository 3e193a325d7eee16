"""
Language server: what the worker knows about a program, over the Language Server Protocol 3.17, for any editor.

``document`` (texts and positions), ``diagnostics`` (problems and their fixes) and ``hover`` are pure; ``checks`` and
``program_run`` use the worker, ``text_service`` codegen. ``lsp/README.md`` says which request gives what.
"""
