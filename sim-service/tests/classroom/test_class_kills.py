"""What a class has acknowledged outlives SIGKILL: 20 kills during saves in ``./rosy test``, 1,000 nightly."""

from __future__ import annotations

import os
import random
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosy_sim.classroom.store.class_store import Admission, ClassStore, Pupil
from rosy_sim.classroom.store.database import SqliteDatabase

from ..cluster.ray_nodes import CLUSTER_PYTHON
from ..conftest import PATIENCE
from ..extent import NIGHTLY, SEED
from ..postgresql_server import needs_postgresql

KILLS = 1000 if NIGHTLY else 20

WRITER = """
import sys
from pathlib import Path
from rosy_sim.classroom.store.class_store import Admission, ClassStore
from rosy_sim.classroom.store.database import SqliteDatabase

if sys.argv[1].startswith("postgresql:"):
    from rosy_sim.classroom.store.postgresql_database import PostgresqlDatabase

    database = PostgresqlDatabase(sys.argv[1], sys.argv[3])
else:
    database = SqliteDatabase(Path(sys.argv[1]))
store = ClassStore(database, Admission("code", "key"), 0.0)
turn = sys.argv[2]
pupil = store.pupil_of("token") or store.join("Ada", lambda: "a b c", "token", 0.0)
base = next((v.number for v in store.programs(pupil.id)), 0)
count = 0
while True:
    count += 1
    text = f"{turn} {count} " + "x" * (count * 997 % 5000)
    base = store.save(pupil.id, "p", "walk", text, "change", base, f"{turn}-{count}", [], 0.0).number
    sys.stdout.write(f"{base} {turn} {count}\\n")
    sys.stdout.flush()
"""


@pytest.mark.long
def test_nothing_acknowledged_is_missing_after_kills_during_saves(tmp_path: Path) -> None:
    database = tmp_path / "class.sqlite3"
    reported = 0
    for acknowledged in _killed_writers([sys.executable, "-c", WRITER, str(database)], []):
        store = ClassStore(SqliteDatabase(database), Admission("", ""), 0.0)
        assert_kept(store, acknowledged)
        reported += int(acknowledged[2])
        assert store._database.execute("PRAGMA integrity_check").fetchone() == ("ok",)
        store.close()
    # Shown by `pytest -s`.
    print(f"{KILLS} kills, {reported} saves reported, 0 missing")


@needs_postgresql
@pytest.mark.long
def test_nothing_acknowledged_is_missing_on_a_server_after_kills_of_its_client(server: str) -> None:
    from rosy_sim.classroom.store.postgresql_database import PostgresqlDatabase

    for acknowledged in _killed_writers([str(CLUSTER_PYTHON), "-c", WRITER, server], ["kills"]):
        # The server has noticed the death when the class can be opened.
        store = ClassStore(PostgresqlDatabase(server, "kills", patience=PATIENCE), Admission("", ""), 0.0)
        assert_kept(store, acknowledged)
        store.close()


def _killed_writers(command: list[str], more: list[str]) -> Iterator[list[str]]:
    """What each writer has acknowledged last: version, turn, count."""
    chance = random.Random(SEED)
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parents[2])}
    for turn in range(KILLS):
        with subprocess.Popen(
            [*command, str(turn), *more], env=environment, stdout=subprocess.PIPE, text=True
        ) as writer:
            assert writer.stdout is not None
            for _ in range(chance.randrange(1, 40)):
                acknowledged = writer.stdout.readline().split()
            writer.kill()
            # Acknowledged before the kill and not read yet.
            for line in writer.stdout.readlines():
                acknowledged = line.split() if line.endswith("\n") else acknowledged
        yield acknowledged


def assert_kept(store: ClassStore, acknowledged: list[str]) -> None:
    pupil = store.pupil_of("token")
    assert isinstance(pupil, Pupil)
    kept = {version.number: version.text.split()[:2] for version in store.history(pupil.id)}
    assert kept[int(acknowledged[0])] == acknowledged[1:]
    # At most one save was going on; nothing before it is missing.
    mine = sorted(int(count) for saved, count in kept.values() if saved == acknowledged[1])
    assert mine[-1] - int(acknowledged[2]) in (0, 1)
    assert mine == list(range(mine[0], mine[-1] + 1))
