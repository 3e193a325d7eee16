"""`./rosy doctor`: what it finds on machines of many kinds, and on this one, also before anything is installed."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import replace
from getpass import getuser
from pathlib import Path

import pytest

from rosy_sim.doctor import Finding, Machine, findings
from rosy_sim.sentences.sentence import tr, verbatim
from rosy_sim.version import VERSION

ROOT = Path(__file__).resolve().parents[2]

DEBIAN = {"ID": "debian", "VERSION_ID": "12", "PRETTY_NAME": "Debian GNU/Linux 12 (bookworm)"}

HEALTHY = Machine(
    version="1.2.3",
    kind="clone",
    release=DEBIAN,
    system="Linux",
    architecture="x86_64",
    processors=2,
    memory=4000,
    free_disk=9000,
    disk_to_build=1600,
    python="3.11.2",
    ghc="9.0.2",
    supported_ghc=("9.0", "9.10"),
    sandbox_fault=None,
    is_built=True,
    run_fault=None,
    run_seconds=2.04,
    has_page=True,
    is_port_in_use=False,
    cables=(),
)


def found(machine: Machine, state: str) -> list[Finding]:
    return [finding for finding in findings(machine) if finding.state == state]


def test_a_healthy_machine_has_nothing_to_advise() -> None:
    lines = list(findings(HEALTHY))
    assert {line.state for line in lines} == {"good"}
    assert all(line.advice is None for line in lines)
    said = "\n".join(str(line.sentence) for line in lines)
    assert "Rosy 1.2.3" in said
    assert "compiled and drove: 2" in said


@pytest.mark.parametrize(
    ("machine", "what", "advice"),
    [
        (replace(HEALTHY, release={**DEBIAN, "VERSION_ID": "11"}), "x86_64", "Debian 12"),
        (replace(HEALTHY, release={"ID": "fedora", "PRETTY_NAME": "Fedora Linux 43"}), "Fedora Linux 43", "Debian 12"),
        (replace(HEALTHY, release={"ID": "ubuntu", "VERSION_ID": "22.04"}), "x86_64", "Ubuntu 24.04"),
        (replace(HEALTHY, system="Darwin", release={}), "Darwin", "WSL 2"),
        (replace(HEALTHY, free_disk=150), "150 MB", "200 MB"),
        (replace(HEALTHY, is_built=False, free_disk=1500), "1500 MB", "1600 MB"),
        (replace(HEALTHY, ghc="8.8.4"), "GHC 8.8.4", "Debian 12"),
        (replace(HEALTHY, ghc="9.1.0"), "GHC 9.1.0", "9.0 9.10"),
        (replace(HEALTHY, run_fault="the worker died"), "the worker died", "./rosy run"),
        (replace(HEALTHY, sandbox_fault=tr("bubblewrap is not installed")), "bubblewrap", "apt install bubblewrap"),
        (replace(HEALTHY, sandbox_fault=verbatim("No permissions")), "No permissions", "you trust"),
        (replace(HEALTHY, cables=(("/dev/ttyUSB0", False),)), "/dev/ttyUSB0", "dialout"),
    ],
)  # fmt: skip
def test_what_does_not_work_is_named_with_what_to_do(machine: Machine, what: str, advice: str) -> None:
    [fault] = found(machine, "bad")
    assert what in str(fault.sentence)
    assert fault.advice is not None
    assert advice in str(fault.advice) + str(fault.sentence)


@pytest.mark.parametrize(
    ("machine", "what"),
    [
        (replace(HEALTHY, is_port_in_use=True), "Port 8080"),
        (replace(HEALTHY, ghc=None), "not installed yet"),
        (replace(HEALTHY, is_built=False), "Nothing is built"),
        (replace(HEALTHY, has_page=False), "The page is not built"),
    ],
)
def test_what_a_start_does_by_itself_is_no_fault(machine: Machine, what: str) -> None:
    assert found(machine, "bad") == []
    assert what in " ".join(str(note.sentence) for note in found(machine, "note"))


@pytest.mark.parametrize("release", [{"ID": "debian"}, {"ID": "ubuntu", "VERSION_ID": "26.04"}, DEBIAN])
def test_newer_systems_are_supported(release: dict[str, str]) -> None:
    assert found(replace(HEALTHY, release=release), "bad") == []


def test_a_stick_brings_its_own_compiler_to_any_linux() -> None:
    stick = replace(HEALTHY, kind="stick", release={"ID": "fedora"}, ghc=None)
    assert {line.state for line in findings(stick)} == {"good"}


def test_here_it_tries_a_program_and_names_nobody() -> None:
    done = subprocess.run(
        [ROOT / "rosy", "doctor"], capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C.UTF-8"}
    )
    assert done.stdout.startswith(f"✓ Rosy {VERSION}\n"), done.stderr
    assert "✓ A small program was compiled and drove" in done.stdout
    assert str(ROOT) not in done.stdout
    assert not re.search(rf"\b(?:{getuser()}|{os.uname().nodename})\b", done.stdout)
    assert done.returncode == ("✗" in done.stdout)


def test_it_needs_nothing_but_the_standard_library() -> None:
    # -S: without the packages that are installed beside it.
    command = [sys.executable, "-S", "-c", "import rosy_sim.doctor"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT / "sim-service")
    assert (done.returncode, done.stderr) == (0, "")


def test_the_version_is_printed_without_any_set_up() -> None:
    done = subprocess.run([ROOT / "rosy", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"Rosy {VERSION}\n"


def test_a_word_behind_it_is_refused_in_a_sentence() -> None:
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    done = subprocess.run(
        [ROOT / "rosy", "doctor", "now"], capture_output=True, text=True, check=False, env=environment
    )
    assert (done.returncode, done.stdout, done.stderr) == (1, "", "rosy: doctor takes nothing.\n")
