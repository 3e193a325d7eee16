"""Map files and their images: what map_saver writes, what people write, and a sentence for each mistake."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from rosy_sim.errors import BadInput
from rosy_sim.maps.graymap import read_graymap
from rosy_sim.maps.map_file import read_map_file

from .drawn_map import as_text, binary, map_file, rectangle

ROWS = rectangle(12, 10)

NO_HEADER = "scan.pgm is damaged: this is not the header of a PGM image with 8 bits per pixel."


def refusal(path: Path, read: Callable[[Path], object] = read_map_file) -> str:
    with pytest.raises(BadInput) as refused:
        read(path)
    return str(refused.value).replace(f"{path.parent}/", "")


def test_what_map_saver_of_both_ros_writes(tmp_path: Path) -> None:
    path = tmp_path / "map.yaml"
    path.write_text(
        "image: map.pgm\nresolution: 0.050000\norigin: [-10.000000, -1.5, 0.000000]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\n\n"
    )
    found = read_map_file(path)
    assert (found.image, found.resolution, found.origin) == (tmp_path / "map.pgm", 0.05, (-10.0, -1.5, 0.0))
    assert (found.negate, found.occupied_above, found.free_below) == (False, 0.65, 0.196)
    path.write_text(
        '---\n# by hand\nimage: "../a b.pgm"  # elsewhere\nmode: scale\nresolution: 5e-2\norigin:\n- -1\n- 2\n  - .5\n'
        "negate: true\noccupied_thresh: 0.65\nfree_thresh: 0.25\nauthor: Ada\n"
    )
    found = read_map_file(path)
    assert (found.image, found.resolution, found.origin) == (tmp_path / "../a b.pgm", 0.05, (-1.0, 2.0, 0.5))
    assert found.negate


def test_an_image_is_looked_for_in_the_folder_of_the_map(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "maps"
    map_file(folder, binary(ROWS))
    monkeypatch.chdir(tmp_path)
    assert read_graymap(read_map_file(Path("maps/scan.yaml")).image).width == 12
    absolute = folder / "scan.pgm"
    assert read_map_file(map_file(tmp_path / "other", b"", image=absolute)).image == absolute


@pytest.mark.parametrize(
    ("changed", "sentence"),
    [
        *(
            ({key: None}, f"scan.yaml does not say {key}; a map of ROS has "
             "image, resolution, origin, negate, occupied_thresh, free_thresh.")
            for key in ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")
        ),
        ({"mode": "raw"}, "scan.yaml: the mode raw is not supported; use trinary or scale."),
        *(
            ({key: value}, f"scan.yaml: this cannot be the {key} of a map: {value}")
            for key, value in [
                ("resolution", "0"), ("resolution", "fine"), ("resolution", "nan"), ("origin", "[1, 2]"),
                ("origin", "here"), ("origin", "[1, 2, inf]"), ("negate", "2"), ("free_thresh", "0.7"),
                ("image", '""'),
            ]
        ),
    ],
)  # fmt: skip
def test_what_is_missing_or_wrong_is_named(changed: dict[str, object], sentence: str, tmp_path: Path) -> None:
    assert refusal(map_file(tmp_path, b"", **changed)) == sentence


@pytest.mark.parametrize("text", ["hello\n", '{"size": [5, 4]}\n', "image: a\nimage: b\n", "- 1\n", "a: 1\n  b: 2\n"])
def test_what_is_no_map_is_refused_with_its_line(text: str, tmp_path: Path) -> None:
    path = tmp_path / "map.yaml"
    path.write_text(text)
    line = text.count("\n")
    assert refusal(path) == f"map.yaml is not a map of ROS: line {line} is not of the form key: value."


def test_files_that_are_not_there(tmp_path: Path) -> None:
    assert refusal(tmp_path / "no.yaml") == "There is no file no.yaml."
    assert refusal(tmp_path / "no.pgm", read_graymap) == "There is no file no.pgm."
    assert refusal(tmp_path / "sub/..", read_graymap).startswith("There is no file")
    (tmp_path / "map.yaml").write_bytes(b"\xff\xfe")
    assert refusal(tmp_path / "map.yaml") == "map.yaml is not a map: it is not text in UTF-8."


@pytest.mark.parametrize("image", [binary(ROWS), as_text(ROWS)])
def test_a_truncated_image_is_refused(image: bytes, tmp_path: Path) -> None:
    path = tmp_path / "scan.pgm"
    path.write_bytes(image)
    whole = read_graymap(path)
    assert (whole.width, whole.height, len(whole.pixels)) == (12, 10, 120)
    assert set(whole.pixels) == {0, 254}
    cut = image[:-50] if image.startswith(b"P5") else image[: image.rindex(b"0 254")]
    path.write_bytes(cut)
    assert refusal(path, read_graymap).startswith("scan.pgm is cut short: it has ")


@pytest.mark.parametrize(
    ("image", "sentence"),
    [
        (b"\x89PNG\r\n\x1a\n", "scan.pgm is not a PGM image; convert it, for example with: convert scan.pgm map.pgm"),
        (b"P5 2 2 65535\n12345678", NO_HEADER),
        (b"P5 2", NO_HEADER),
        (b"P5 0 2 255\n", NO_HEADER),
        (b"P2 2 1 255\n0 256\n", "scan.pgm is damaged: pixel 2 is no number from 0 to 255."),
        (b"P2 2 1 255\n0 -1\n", "scan.pgm is damaged: pixel 2 is no number from 0 to 255."),
        (b"P5 99999 99999 255\n", "scan.pgm has 99999 by 99999 pixels; a map can have at most 16000000 in all."),
    ],
)  # fmt: skip
def test_images_that_are_none(image: bytes, sentence: str, tmp_path: Path) -> None:
    path = tmp_path / "scan.pgm"
    path.write_bytes(image)
    assert refusal(path, read_graymap) == sentence


def test_fewer_levels_of_grey_are_stretched(tmp_path: Path) -> None:
    path = tmp_path / "scan.pgm"
    path.write_bytes(b"P2 3 1 2\n0 1 2\n")
    assert list(read_graymap(path).pixels) == [0, 128, 255]
