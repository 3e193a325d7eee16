"""Options of all commands. `languages/en/help` says what they are for."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import NoReturn

from ..classroom.command import add_class_options
from ..cluster.command import add_cluster_options
from ..errors import BadInput
from ..maps.command import add_room_options
from ..programs.program_file import OLDER_ENCODINGS
from ..recordings.command import add_replay_options
from ..rooms.command import add_options
from ..sentences.sentence import tr
from ..sentences.usage_errors import usage_error
from ..worker.native_build import PROCESSORS

__all__ = ["options_parser"]


class Parser(argparse.ArgumentParser):
    """One sentence instead of a page of usage; `languages/en/help` has that."""

    def error(self, message: str) -> NoReturn:
        raise BadInput(
            tr("{message}. ./{program} --help says what there is.", message=usage_error(message), program=self.prog)
        )


def options_parser() -> argparse.ArgumentParser:
    parser = Parser(prog="rosy", add_help=False, allow_abbrev=False)
    commands = parser.add_subparsers(dest="command", required=True, parser_class=Parser)
    serve = commands.add_parser("serve", prog="rosy start", add_help=False, allow_abbrev=False)
    serve.add_argument("--port", type=int, default=8080)
    serve.add_argument("--host")
    serve.add_argument("--public", metavar="URL")
    serve.add_argument("--class", dest="class_name", nargs="?", const="class", metavar="NAME")
    serve.add_argument("--no-browser", action="store_true")
    serve.add_argument("--runs", type=int)
    serve.add_argument("--robot", action="append", default=[], metavar="NAME=ADDRESS")
    serve.add_argument("--ros2", nargs="?", const="ros2:", metavar="DOMAIN")
    serve.add_argument("--robots", type=Path, metavar="FILE")
    serve.add_argument("--unprotected", action="store_true")
    serve.add_argument("--no-record", action="store_true")
    add_cluster_options(commands.add_parser("node", prog="rosy start", add_help=False, allow_abbrev=False))
    check = commands.add_parser("check", prog="rosy check", add_help=False, allow_abbrev=False)
    check.add_argument("file", type=Path)
    check.add_argument("--json", action="store_true")
    build = commands.add_parser("build", prog="rosy build", add_help=False, allow_abbrev=False)
    build.add_argument("file", type=Path)
    build.add_argument("-o", dest="output", type=Path, required=True, metavar="BIN")
    build.add_argument("--for", dest="processor", choices=tuple(PROCESSORS.values()))
    lsp = commands.add_parser("lsp", prog="rosy lsp", add_help=False, allow_abbrev=False)
    # Editors add it to name the transport; there is no other one.
    lsp.add_argument("--stdio", action="store_true")
    robots = commands.add_parser("robots", prog="rosy robots", add_help=False, allow_abbrev=False)
    robots.add_argument("addresses", nargs="*", default=["ros2:"], metavar="ADDRESS")
    robots.add_argument("--seconds", type=float, default=5.0)
    add_room_options(commands.add_parser("room", prog="rosy room", add_help=False, allow_abbrev=False))
    replay = commands.add_parser("replay", prog="rosy replay", add_help=False, allow_abbrev=False)
    add_replay_options(replay)
    add_class_options(commands.add_parser("class", prog="rosy class", add_help=False, allow_abbrev=False))
    run = commands.add_parser("run", prog="rosy run", add_help=False, allow_abbrev=False)
    run.add_argument("files", type=Path, nargs="+", metavar="file")
    run.add_argument("--world")
    run.add_argument("--seconds", type=float)
    run.add_argument("--seed", type=int)
    run.add_argument("--speed")
    run.add_argument("--trace", type=Path)
    run.add_argument("--input", type=Path)
    run.add_argument("--robot")
    run.add_argument("--record", type=Path, metavar="FILE")
    run.add_argument("--no-record", action="store_true")
    run.add_argument("--csv", action="store_true")
    add_options(run)
    run.add_argument("--safety", choices=("on", "off"))
    run.add_argument("--max-speed", type=float)
    run.add_argument("--max-turn", type=float)
    run.add_argument("--provenance", action="store_true")
    run.add_argument("--explain", nargs="?", const="")
    for reads_programs in (check, build, replay, run):
        reads_programs.add_argument("--encoding", type=str.lower, choices=OLDER_ENCODINGS)
    return parser
