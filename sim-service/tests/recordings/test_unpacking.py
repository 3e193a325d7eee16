"""Reading an untrusted recording takes bounded memory: neither its unpacked size nor the sizes in its headers count."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import lz4.frame
import msgspec
import pytest
import zstandard
from mcap.data_stream import RecordBuilder
from mcap.records import Attachment, Channel, Chunk, DataEnd, Footer, Header, McapRecord, Message, Metadata

from rosy_sim.recordings.mcap_records import LARGEST

MAGIC = b"\x89MCAP0\r\n"

MEMORY = 250_000
"""kB: some 80 MB are Python's and its libraries', the rest is a record of the largest size, packed and unpacked."""

PACKED: dict[str, Callable[[bytes], bytes]] = {
    "": bytes,
    "zstd": zstandard.ZstdCompressor(level=19).compress,
    "lz4": lz4.frame.compress,
}


def written(*records: McapRecord) -> bytes:
    builder = RecordBuilder()
    for record in records:
        record.write(builder)
    return bytes(builder.end())  # type: ignore[no-untyped-call]


def chunk(messages: int, length: int, compression: str, stated: int | None = None) -> Chunk:
    """Messages of zeros; `stated` is the size that the chunk claims to unpack to."""
    data = written(
        Channel(id=1, topic="/odom", message_encoding="json", metadata={"source": "to_program"}, schema_id=0),
        *(Message(channel_id=1, data=bytes(length), log_time=n, publish_time=n, sequence=n) for n in range(messages)),
    )
    size = len(data) if stated is None else stated
    return Chunk(compression, PACKED[compression](data), messages, 0, 0, size)


def recording(*chunks: McapRecord) -> bytes:
    program = Attachment(create_time=0, log_time=0, name="program.hs", media_type="text/plain", data=b"main = pure ()")
    records = [
        Header(profile="", library=""),
        *chunks,
        program,
        Metadata(name="rosy", metadata={"complete": "yes"}),
        DataEnd(0),
    ]
    return MAGIC + written(*records, Footer(summary_start=0, summary_offset_start=0, summary_crc=0)) + MAGIC


# The peak of the memory of a process that has begun since exec(2); ru_maxrss includes that of its parent.
READING = """
import re, sys
from pathlib import Path
from rosy_sim.recordings.reading_process import main
status = main("bomb.mcap")
print(re.search("VmHWM:\\s+(\\d+) kB", Path("/proc/self/status").read_text())[1], file=sys.stderr)
sys.exit(status)
"""


def read(data: bytes, folder: Path) -> tuple[str, int]:
    """What the process that reads it says first, and the memory that it took, kB."""
    path, said = folder / "bomb.mcap", folder / "said"
    path.write_bytes(data)
    with path.open("rb") as stdin, said.open("wb") as stdout:
        done = subprocess.run(
            [sys.executable, "-c", READING], stdin=stdin, stdout=stdout, stderr=subprocess.PIPE, check=True
        )
    with said.open("rb") as stream:
        first = msgspec.json.decode(stream.readline())
    said.unlink()
    return str(first.get("message") or "read"), int(done.stderr)


@pytest.mark.parametrize("compression", ["zstd", "lz4"])
def test_chunks_at_the_same_time_are_unpacked_one_after_the_other(compression: str, tmp_path: Path) -> None:
    many = [chunk(30, 1_000_000, compression)] * 20
    data = recording(*many)
    assert len(data) < 5_000_000
    said, memory = read(data, tmp_path)
    assert said == "read"
    assert memory < MEMORY


@pytest.mark.parametrize("compression", PACKED)
def test_a_chunk_that_unpacks_to_too_much_is_refused(compression: str, tmp_path: Path) -> None:
    said, memory = read(recording(chunk(40, 1_000_000, compression)), tmp_path)
    assert said == "bomb.mcap is too large for a recording of a run."
    assert memory < MEMORY


@pytest.mark.parametrize("compression", PACKED)
@pytest.mark.parametrize("stated", [0, 31, 1_000])
def test_a_chunk_that_states_less_than_it_unpacks_to_gives_that(stated: int, compression: str, tmp_path: Path) -> None:
    said, memory = read(recording(chunk(30, 1_000_000, compression, stated)), tmp_path)
    assert said == "read" or said.startswith("bomb.mcap is no recording of a run, or is damaged.")
    assert memory < MEMORY


def test_a_description_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    large = Attachment(create_time=0, log_time=0, name="program.hs", media_type="text/plain", data=bytes(LARGEST))
    said, memory = read(recording(large), tmp_path)
    assert said == "bomb.mcap is too large for a recording of a run."
    assert memory < MEMORY
