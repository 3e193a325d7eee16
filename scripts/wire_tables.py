"""
Check that the tables of the protocol name every message between the service and the page, the board and the projector, and its fields.

In: the structs that `wire_typescript` reads, and the rows `| from | op | fields | meaning |` of ``protocol/README.md``. Out: a line for each
message or field that no row names, and for each row of a message that no struct has.
"""

from __future__ import annotations

import importlib
import re
import sys
from collections.abc import Iterator

from msgspec import inspect as mi

from wire_typescript import ROOT, ROOTS

TABLES = "protocol/README.md"

# Answered by the sockets themselves, before the message is read.
WITHOUT_STRUCT = {"ping"}


def rows(text: str) -> Iterator[tuple[str, str, str]]:
    """The sender, each message that the row is about, and the cell of its fields."""
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) >= 6 and cells[2].startswith("`") and " " not in cells[2].split("`")[1]:
            for op in re.findall(r"`([A-Za-z-]+)`", cells[2]):
                yield cells[1], op, cells[3]


def unnamed(fields: list[str], cells: str) -> list[str]:
    return [field for field in fields if not re.search(rf'[`"]{field}\b', cells)]


def breaches(text: str) -> Iterator[str]:
    known = set(WITHOUT_STRUCT)
    found = list(rows(text))
    for module, name, _ in ROOTS:
        union = mi.type_info(getattr(importlib.import_module(module), name))
        for struct in union.types if isinstance(union, mi.UnionType) else [union]:
            if not isinstance(struct, mi.StructType):
                continue
            known.add(str(struct.tag))
            fields = [field.encode_name for field in struct.fields]
            missing = [unnamed(fields, cells) for _, op, cells in found if op == struct.tag]
            if not missing:
                yield f"{TABLES}: no row is about `{struct.tag}` of {name}"
            elif all(missing):
                yield f"{TABLES}: the row of `{struct.tag}` of {name} does not name {', '.join(min(missing, key=len))}"
    for sender, op, _ in found:
        if set(re.split(r"\W+", sender)) & {"page", "board", "projector"} and op not in known:
            yield f"{TABLES}: `{op}` of {sender} is no message of the service's structs"


def main() -> int:
    lines = list(breaches((ROOT / TABLES).read_text()))
    print("".join(f"{line}\n" for line in lines), end="")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
