"""Set-up by `./rosy`: what is missing is told at once and together, and what is there is not done again."""

from __future__ import annotations

import json
import os
import re
import shutil
import socket
import subprocess
import threading
from pathlib import Path

import pytest

from .sandbox import COMPLETE, ROOT, VERSION, Machine, machine


@pytest.fixture
def complete(tmp_path: Path) -> Machine:
    return machine(tmp_path)


def missing(complete: Machine, *arguments: str, env: dict[str, str] | None = None) -> list[str]:
    """The list that a failed start prints; nothing may have been installed."""
    done = complete.rosy("start", *arguments, env=env)
    assert done.returncode == 1, done.stderr
    assert "Traceback" not in done.stderr
    assert complete.called("install -y") == complete.called("-m venv") == complete.called("npm install") == 0
    return done.stderr.splitlines()


def test_a_start_does_each_step_once_and_the_next_one_none(complete: Machine) -> None:
    first = complete.rosy("start")
    assert (first.returncode, first.stdout) == (0, "served -m rosy_sim serve\n"), first.stderr
    assert "nothing to download" in first.stderr or "MB to download" in first.stderr
    steps = {"-m venv", "npm install", "cabal build", "-w @rosy/codegen", "-w @rosy/editor"}
    counts = {step: complete.called(step) for step in steps}
    assert all(counts.values())
    second = complete.rosy("start", "--port", "0")
    assert (second.returncode, second.stderr) == (0, "")
    assert {step: complete.called(step) for step in steps} == counts


def test_start_installs_no_test_tools(complete: Machine) -> None:
    complete.rosy("start")
    assert complete.called("requirements-test.lock") == 0
    assert complete.called("npm install") == complete.called("--omit=dev") == 1


def test_the_browsers_of_other_engines_are_installed_with_the_test_tools_where_apt_knows_them(complete: Machine) -> None:
    complete.tool("dpkg-query", "exit 1")
    complete.tool("apt-cache", 'case "$*" in "show firefox-esr") exit 100 ;; *) echo "  Candidate: 9.0.2-4" ;; esac')
    complete.tool("apt-get", 'case "$*" in *xvfb*) exit 100 ;; esac')
    done = complete.rosy("test", "none")
    assert complete.called("webkit2gtk-driver xvfb") == 1
    assert complete.called("install -y --no-install-recommends firefox-esr") == 0
    assert "left out by the tests" in done.stderr


def test_a_language_server_builds_no_page_and_leaves_standard_output_to_the_editor(complete: Machine) -> None:
    done = complete.rosy("lsp", "--stdio")
    assert (done.returncode, done.stdout) == (0, "served -m rosy_sim lsp --stdio\n"), done.stderr
    assert complete.called("-w @rosy/codegen") == complete.called("cabal build") == 1
    assert complete.called("-w @rosy/editor") == complete.called("requirements-test.lock") == 0


def test_workspaces_are_named_by_their_package_because_a_folder_also_selects_the_workspaces_in_it() -> None:
    selected = re.findall(r"(?:-w|--workspace) ([@a-z][^\s);]*)", (ROOT / "scripts/lib/setup.sh").read_text())
    folders = json.loads((ROOT / "package.json").read_text())["workspaces"]
    names = {json.loads((ROOT / folder / "package.json").read_text())["name"] for folder in folders}
    assert selected
    assert set(selected) <= names


def test_python_packages_are_installed_by_hash(complete: Machine) -> None:
    complete.rosy("start")
    # Of the service, and of what compiles a part of it.
    assert complete.called("pip install") == complete.called("--require-hashes") == 2


def test_a_changed_lock_file_leaves_the_packages_of_the_tests(complete: Machine) -> None:
    complete.rosy("start")
    tools = complete.root / ".rosy/venv/lib/python3.11/site-packages/pytest"
    tools.mkdir(parents=True)
    lock = complete.root / "sim-service/requirements.lock"
    lock.write_text(lock.read_text() + "# changed\n")
    assert complete.rosy("start").returncode == 0
    assert tools.is_dir()
    assert (complete.called("-m venv"), complete.called("/requirements.lock")) == (1, 2)
    # A folder whose Python has gone is made anew, with what is needed only.
    (complete.root / ".rosy/venv/bin/python").unlink()
    assert complete.rosy("start").returncode == 0
    assert not tools.exists()
    assert complete.called("-m venv") == 2


def test_what_is_computed_in_each_step_is_compiled_once_and_again_when_it_has_changed(complete: Machine) -> None:
    module = complete.root / "sim-service/rosy_sim/world/world.py"
    listed = complete.root / "sim-service/rosy_sim/compiled_modules.py"
    module.parent.mkdir(parents=True)
    listed.write_text('MODULES = (\n    "world.world",\n)\n')
    for text, compiled in [("a = 1", 1), ("a = 1", 1), ("a = 2", 2)]:
        module.write_text(text)
        complete.rosy("start")
        assert complete.called("compile_service.py") == compiled


def test_a_machine_that_cannot_compile_the_service_says_so_once_and_goes_on(complete: Machine) -> None:
    python = (complete.bin / "python3").read_text().partition("\n")[2].partition("\n")[2]
    complete.tool("python3", f'case "$*" in *compile_service*) exit 1 ;; esac\n{python}')
    first = complete.rosy("start")
    assert first.returncode == 0
    assert "could not be compiled; runs take about twice as long. The log is in .rosy/log/compiled.log; to try again, remove .rosy/compiled." in first.stderr
    second = complete.rosy("start")
    assert (second.returncode, second.stderr) == (0, "")


def test_the_headers_of_python_are_installed_where_they_are_missing(complete: Machine) -> None:
    complete.tool("dpkg-query", "exit 1")
    python = (complete.bin / "python3").read_text().partition("\n")[2].partition("\n")[2]
    complete.tool("python3", f'case "$*" in *Python.h*) exit 1 ;; esac\n{python}')
    complete.rosy("start")
    assert any("apt-get" in line and "python3-dev" in line for line in complete.calls.read_text().splitlines())


def test_everything_that_is_missing_is_told_in_one_list(complete: Machine) -> None:
    complete.tool("dpkg-query", "exit 1")
    complete.tool("python3", "exit 1")
    complete.tool("ghc", "echo 8.8.4")
    complete.tool("curl", "exit 6")
    complete.tool("df", 'echo; echo "x 1 1 10 99% /"')
    told = "\n".join(missing(complete))
    for part in ("Python 3.11", "GHC 8.8.4", "no way to the network", "disk space"):
        assert part in told
    # Each sentence comes with a remedy.
    assert told.count("\n      ") == told.count("\n  - ")


def test_without_a_network_it_says_so_before_anything_is_done(complete: Machine) -> None:
    complete.tool("curl", "exit 6")
    assert any("no way to the network" in line for line in missing(complete))


def test_a_certificate_that_is_not_known_is_told_before_anything_is_done(complete: Machine) -> None:
    complete.tool("curl", "exit 60")
    told = "\n".join(missing(complete))
    assert "The certificate of https://packages.example is not known to this machine" in told
    assert "NODE_EXTRA_CA_CERTS=FILE.crt" in told
    assert "no way to the network" not in told


def test_a_certificate_that_is_named_is_used_to_ask_the_servers_and_by_node(complete: Machine) -> None:
    complete.tool("curl", 'case "$*" in *"--cacert school.crt"*) ;; *) exit 60 ;; esac')
    complete.tool("npm", f'echo "npm trusts $NODE_EXTRA_CA_CERTS" >>"{complete.calls}"\n{COMPLETE["npm"]}')
    done = complete.rosy("start", env={"NODE_EXTRA_CA_CERTS": "school.crt"})
    assert done.returncode == 0, done.stderr
    assert complete.called("npm trusts school.crt") > 0


def test_node_trusts_what_the_system_trusts(complete: Machine) -> None:
    complete.tool("npm", f'echo "npm trusts $NODE_EXTRA_CA_CERTS." >>"{complete.calls}"\n{COMPLETE["npm"]}')
    complete.rosy("start")
    certificates = "/etc/ssl/certs/ca-certificates.crt"
    assert complete.called(f"npm trusts {certificates if os.path.exists(certificates) else ''}.") > 0


def test_without_a_network_what_is_installed_still_starts(complete: Machine) -> None:
    complete.rosy("start")
    complete.tool("curl", "exit 6")
    assert complete.rosy("start").returncode == 0


def test_a_user_without_sudo_is_told_what_an_administrator_types(complete: Machine) -> None:
    complete.tool("dpkg-query", "exit 1")
    complete.tool("id", 'case "$1" in -u) echo 1000 ;; *) echo pupil ;; esac')
    (complete.bin / "sudo").unlink(missing_ok=True)
    told = "\n".join(missing(complete))
    assert "as root: apt-get install" in told
    assert "ghc" in told


def test_a_system_without_apt_is_told_which_packages(complete: Machine) -> None:
    complete.lacks("apt-get", "dpkg-query")
    told = "\n".join(missing(complete))
    assert "no apt" in told
    assert "libghc-aeson-dev" in told


@pytest.mark.parametrize(
    ("release", "is_old"),
    [
        ('ID=ubuntu\nVERSION_ID="22.04"\nPRETTY_NAME="Ubuntu 22.04.5 LTS"\n', True),
        ('ID=debian\nVERSION_ID="11"\nPRETTY_NAME="Debian GNU/Linux 11 (bullseye)"\n', True),
        ('ID=ubuntu\nVERSION_ID="24.04"\nPRETTY_NAME="Ubuntu 24.04.4 LTS"\n', False),
        ('ID=debian\nVERSION_ID="13"\nPRETTY_NAME="Debian GNU/Linux 13 (trixie)"\n', False),
        ('ID=debian\nPRETTY_NAME="Debian GNU/Linux forky/sid"\n', False),
    ],
)
def test_a_system_that_is_too_old_is_told_so_instead_of_a_newer_python(complete: Machine, release: str, is_old: bool) -> None:
    """Ubuntu 22.04 has a Python 3.11 to install, but no GHC: who installed the one was then told of the other."""
    (complete.root / "os-release").write_text(release)
    complete.lacks("ghc")
    for name in ("python3", *(f"python3.{minor}" for minor in range(11, 15))):
        complete.tool(name, "exit 1")
    told = "\n".join(missing(complete, env={"ROSY_OS_RELEASE": str(complete.root / "os-release")}))
    assert ("is older than Rosy needs" in told) == is_old
    assert ("Python 3.11 or newer" in told) != is_old
    assert (release.split('PRETTY_NAME="')[1].split('"')[0] in told) == is_old


def test_another_system_is_named(complete: Machine) -> None:
    complete.tool("uname", "echo Darwin")
    assert any("this is Darwin" in line for line in missing(complete))


def test_a_port_in_use_is_told_before_the_installation(complete: Machine) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        (said,) = missing(complete, "--port", str(port))
        assert f"port {port} is in use" in said
        assert said.endswith(f"./rosy start --port {port + 1}")


def test_a_node_that_is_missing_comes_as_a_python_package(complete: Machine) -> None:
    complete.lacks("node")
    complete.tool("npm", "exit 127")
    done = complete.rosy("start")
    assert complete.called("requirements-node.lock") == 1
    # The fake package is empty, so the step fails, with a sentence.
    assert done.returncode == 1
    assert "this step failed: Installing Node." in done.stderr


def test_help_and_estop_need_nothing(complete: Machine) -> None:
    complete.lacks("apt-get", "dpkg-query", "ghc", "cabal", "node", "npm", "curl", "find", "sha1sum")
    assert complete.rosy("help").returncode == 0
    assert complete.rosy("help", "start").returncode == 0
    assert complete.rosy("estop").returncode == 0
    assert complete.called("estop") == 1
    assert not (complete.root / ".rosy").exists()


def test_a_folder_that_cannot_be_written_gives_one_sentence(complete: Machine) -> None:
    complete.root.chmod(0o555)
    # Without its capabilities root is held to the permissions of files, like any user.
    powerless = ["setpriv", "--bounding-set=-all", "--inh-caps=-all"] if os.geteuid() == 0 else []
    setpriv = {"PATH": f"{complete.env['PATH']}:{os.environ['PATH']}"}
    done = subprocess.run([*powerless, complete.root / "rosy", "start"], env={**complete.env, **setpriv}, capture_output=True, text=True, check=False)
    complete.root.chmod(0o755)
    assert done.returncode == 1
    assert len(done.stderr.splitlines()) == 1
    assert "cannot be written" in done.stderr
    assert not (complete.root / ".rosy").exists()


def test_an_interrupted_step_is_done_again(complete: Machine) -> None:
    complete.tool("cabal", "kill -TERM $$")
    assert complete.rosy("start").returncode == 1
    complete.tool("cabal", COMPLETE["cabal"])
    assert complete.rosy("start").returncode == 0
    assert complete.called("-m venv") == 1


def test_a_failed_step_names_its_log(complete: Machine) -> None:
    complete.tool("cabal", "echo the reason; exit 1")
    done = complete.rosy("start")
    assert done.returncode == 1
    assert "the reason" in done.stderr
    assert ".rosy/log/haskell.log" in done.stderr


def test_two_starts_at_once_do_each_step_once(complete: Machine) -> None:
    results: list[int] = []
    both = [threading.Thread(target=lambda: results.append(complete.rosy("start").returncode)) for _ in range(2)]
    for one in both:
        one.start()
    for one in both:
        one.join()
    assert results == [0, 0]
    assert complete.called("-m venv") == complete.called("cabal build") == 1


def test_a_path_with_spaces_and_umlauts(tmp_path: Path) -> None:
    here = machine(tmp_path / "Schöne neue Übung", "Rosy für alle")
    done = here.rosy("start")
    assert (done.returncode, done.stdout) == (0, "served -m rosy_sim serve\n"), done.stderr


def test_a_result_that_was_taken_away_is_made_again(complete: Machine) -> None:
    complete.rosy("start")
    shutil.rmtree(complete.root / "editor/dist")
    assert complete.rosy("start").returncode == 0
    assert complete.called("npm install") == complete.called("-w @rosy/editor") == 2
    assert complete.called("-w @rosy/codegen") == 1


def test_what_only_the_builds_need_is_not_kept(complete: Machine) -> None:
    complete.rosy("start")
    assert complete.called("npm install") == 1
    assert not (complete.root / "node_modules").exists()
    assert complete.called("Keep-Downloaded-Packages=false") == complete.called("apt-get")


def test_the_packages_of_the_tests_are_kept(complete: Machine) -> None:
    complete.rosy("test")
    complete.rosy("start")
    assert complete.called("--omit=dev") == 0
    assert (complete.root / "node_modules").exists()


def test_a_changed_lock_file_of_npm_leaves_the_packages_of_the_tests(complete: Machine) -> None:
    installs = 'case "$*" in *install*--omit=dev*) rm -rf node_modules/vitest ;; *install*) mkdir -p node_modules/vitest ;; esac'
    complete.tool("npm", f"{installs}\n{COMPLETE['npm']}")
    complete.rosy("test", "none")
    lock = complete.root / "package-lock.json"
    lock.write_text(lock.read_text() + " ")
    assert complete.rosy("start").returncode == 0
    assert complete.called("npm install") == 2
    assert (complete.root / "node_modules/vitest").is_dir()


def test_the_tests_install_ray_after_everything_else(complete: Machine) -> None:
    done = complete.rosy("test", "python")
    assert complete.called("requirements-cluster.lock") == 1
    # What bash itself says of a fault in the script.
    assert "setup.sh: line" not in done.stderr


def test_an_update_builds_only_what_changed(complete: Machine) -> None:
    complete.rosy("start")
    (complete.root / "editor/src/new.ts").write_text("new")
    assert complete.rosy("start").returncode == 0
    assert complete.called("-w @rosy/editor") == complete.called("npm install") == 2
    assert complete.called("-w @rosy/codegen") == complete.called("cabal build") == complete.called("-m venv") == 1
    assert not (complete.root / "node_modules").exists()


def test_without_a_network_a_changed_example_leaves_the_page_as_it_was(complete: Machine) -> None:
    complete.rosy("start")
    complete.tool("curl", "exit 6")
    complete.tool("npm", 'case "$*" in *registry*) echo https://packages.example ;; esac')
    (complete.root / "examples/new.hs").write_text("main = simulate id")
    done = complete.rosy("start")
    assert (done.returncode, done.stdout) == (0, "served -m rosy_sim serve\n"), done.stderr
    assert "The page is the one of the last build" in done.stderr
    complete.tool("npm", COMPLETE["npm"])
    complete.tool("curl", "")
    complete.rosy("start")
    assert complete.called("-w @rosy/editor") == 2


def test_a_library_that_a_killed_build_left_unfinished_is_linked_again(complete: Machine) -> None:
    build = f"dist-newstyle/build/x86_64-linux/ghc-9.0.2/rosy-{VERSION}"
    whole, part, checked = (complete.root / build / name for name in ("build/libHSros.so", "build/libHSrosy.so", "cache/build"))
    for file in (whole, checked):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    # Killed as the kernel does it when memory is short: the shell as well.
    complete.tool("cabal", f'touch -d "now + 5 seconds" "$ROSY_ROOT/{part.relative_to(complete.root)}"; kill -KILL $PPID $$')
    assert complete.rosy("start").returncode != 0
    assert part.exists()
    complete.tool("cabal", COMPLETE["cabal"])
    assert complete.rosy("start").returncode == 0
    assert whole.exists()
    assert not part.exists()
    assert not checked.exists()


def test_a_newer_version_removes_what_was_built_of_an_older_one(complete: Machine) -> None:
    assert complete.rosy("start").returncode == 0
    older, built = (complete.root / f"dist-newstyle/build/x86_64-linux/ghc-9.0.2/rosy-{version}" for version in (VERSION, "99.0.0"))
    database = complete.root / "dist-newstyle/packagedb/ghc-9.0.2"
    database.mkdir(parents=True)
    for version in (VERSION, "99.0.0"):
        for unit in ("inplace", "inplace-robots"):
            (database / f"rosy-{version}-{unit}.conf").touch()
    cabal_file = complete.root / "rosy.cabal"
    cabal_file.write_text(re.sub(r"(?m)^(version:\s*)\S+", r"\g<1>99.0.0", cabal_file.read_text()))
    complete.tool("cabal", COMPLETE["cabal"].replace(f"rosy-{VERSION}", "rosy-99.0.0"))
    assert complete.rosy("start").returncode == 0
    assert not older.exists()
    assert built.exists()
    assert sorted(file.name for file in database.iterdir()) == ["rosy-99.0.0-inplace-robots.conf", "rosy-99.0.0-inplace.conf"]


def test_a_cabal_that_builds_here_is_waited_for(complete: Machine, tmp_path: Path) -> None:
    other = tmp_path / "elsewhere" / "cabal"
    other.parent.mkdir()
    # The name of a script is the name of its process. A copy of `sleep` would not do: on Ubuntu it is one program with all others, which asks for its name.
    other.write_text("#!/bin/sh\nread -r _\n")
    other.chmod(0o755)
    with (
        subprocess.Popen([other], cwd=complete.root, stdin=subprocess.PIPE) as building,
        subprocess.Popen([complete.root / "rosy", "start"], env=complete.env, stderr=subprocess.PIPE, text=True) as start,
    ):
        told = next((line for line in start.stderr or () if "A cabal of another command" in line), "")
        before = complete.called("cabal build")
        building.kill()
        building.wait()
        start.communicate()
    assert told
    assert before == 0
    assert (start.returncode, complete.called("cabal build")) == (0, 1)
