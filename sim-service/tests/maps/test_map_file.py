"""Map files and their images: what map_saver writes, what people write, and a sentence for each mistake."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image

from rosy_sim.errors import BadInput
from rosy_sim.maps.map_file import read_map_file
from rosy_sim.maps.map_image import read_map_image

from .drawn_map import as_text, binary, map_file, rectangle

ROWS = rectangle(12, 10)

DAMAGED = "The image scan.pgm is damaged or cut short."
NO_IMAGE = "scan.pgm is no image that a map can have: PNG, BMP or PGM."


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
    assert (found.negate, found.occupied_from, found.free_to) == (False, 0.65, 0.196)
    path.write_text(
        '---\n# by hand\nimage: "../a b.pgm"  # elsewhere\nmode: scale\nresolution: 5e-2\norigin:\n- -1\n- 2\n- .5\n'
        "negate: true\noccupied_thresh: 0.65\nfree_thresh: 0.25\nauthor: Ada\n"
    )
    found = read_map_file(path)
    assert (found.image, found.resolution, found.origin) == (tmp_path / "../a b.pgm", 0.05, (-1.0, 2.0, 0.5))
    assert found.negate


def test_an_image_is_looked_for_in_the_folder_of_the_map(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "maps"
    map_file(folder, binary(ROWS))
    monkeypatch.chdir(tmp_path)
    assert read_map_image(read_map_file(Path("maps/scan.yaml")).image).width == 12
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
        ({"mode": "fine"}, "scan.yaml: there is no mode fine; use trinary, scale, raw."),
        *(
            ({key: value}, f"scan.yaml: this cannot be the {key} of a map: {value.strip('[]')}")
            for key, value in [
                ("resolution", "0"), ("resolution", "fine"), ("resolution", "nan"), ("origin", "[1, 2]"),
                ("origin", "here"), ("origin", "[1, 2, inf]"), ("origin", "[nan, 2, 0]"), ("negate", "2"),
                ("free_thresh", "0.7"), ("image", ""),
            ]
        ),
    ],
)  # fmt: skip
def test_what_is_missing_or_wrong_is_named(changed: dict[str, object], sentence: str, tmp_path: Path) -> None:
    assert refusal(map_file(tmp_path, b"", **changed)) == sentence


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("", 1), ("hello\n", 1), ("image: a\nimage: b\n", 2), ("- 1\n", 1), ("a: 1\n  b: 2\n", 2), ("a: 'b\n", 2),
        ("a: 1\nb: [1,\n", 3), ("[" * 50_000, 1), ("? [a]\n: 1\n", 1), ("--- 1\n--- 2\n", 2),
    ],
)  # fmt: skip
def test_what_is_no_map_is_refused_with_its_line(text: str, line: int, tmp_path: Path) -> None:
    path = tmp_path / "map.yaml"
    path.write_text(text)
    assert refusal(path) == f"map.yaml is not a map of ROS: line {line} is not of the form key: value."


def test_files_that_are_not_there(tmp_path: Path) -> None:
    assert refusal(tmp_path / "no.yaml") == "There is no file no.yaml."
    assert refusal(tmp_path / "no.pgm", read_map_image) == "There is no file no.pgm."
    assert refusal(tmp_path / "sub/..", read_map_image).startswith("There is no file")
    (tmp_path / "map.yaml").write_bytes(b"\xff\x00")
    assert refusal(tmp_path / "map.yaml") == "map.yaml is not a map: it is not text in UTF-8."


YAML = """
image: {name}
resolution: 0.05
origin: [-1.5, 2, {yaw}]
negate: {negate}
occupied_thresh: 0.65
free_thresh: 0.25
"""
FLOW = """{{image: {name}, resolution: 0.05, origin: [-1.5,
  2, {yaw}], "negate": {negate}, occupied_thresh: 0.65, free_thresh: 0.25}} # by hand
"""


@pytest.mark.parametrize("style", [YAML, FLOW], ids=["block", "flow"])
@pytest.mark.parametrize(
    ("written", "read"),
    [
        ('"floor #2.pgm"', "floor #2.pgm"),
        ("'it''s #1.pgm' # first", "it's #1.pgm"),
        ("a#b.pgm", "a#b.pgm"),
        ('"\\xE4"', "ä"),
    ],
)  # fmt: skip
def test_names_are_read_as_yaml_quotes_them(style: str, written: str, read: str, tmp_path: Path) -> None:
    if style is FLOW and " # " in written:
        written = written.split(" # ")[0]
    path = tmp_path / "map.yaml"
    path.write_text(style.format(name=written, yaw="0", negate="0"))
    assert read_map_file(path).image == tmp_path / read


@pytest.mark.parametrize("style", [YAML, FLOW], ids=["block", "flow"])
@pytest.mark.parametrize(
    ("yaw", "angle"), [("nan", 0), (".nan", 0), ("-nan", 0), (".NaN", 0), ("1.5e0", 1.5), ("-.5", -0.5), ("2", 2)]
)
def test_an_angle_that_was_never_set_is_none(style: str, yaw: str, angle: float, tmp_path: Path) -> None:
    path = tmp_path / "map.yaml"
    path.write_text(style.format(name="m.pgm", yaw=yaw, negate="0"))
    assert read_map_file(path).origin == (-1.5, 2.0, angle)


@pytest.mark.parametrize(
    ("written", "negate"),
    [(word, value) for value in (False, True) for word in (("no", "No", "n", "off", "FALSE", "0", "'0'"),
                                                           ("yes", "Yes", "y", "on", "TRUE", "1", '"true"'))[value]],
)  # fmt: skip
def test_flags_are_those_of_yaml_and_numbers(written: str, negate: bool, tmp_path: Path) -> None:
    path = tmp_path / "map.yaml"
    path.write_text(YAML.format(name="m.pgm", yaw="0", negate=written))
    assert read_map_file(path).negate is negate


def encoded(kind: str, mode: str = "L") -> bytes:
    file = io.BytesIO()
    image = Image.frombytes("L", (12, 10), bytes({"#": 0, ".": 254}[cell] for row in ROWS for cell in row))
    image.convert(mode).save(file, kind)
    return file.getvalue()


IMAGES = {
    "PGM": binary(ROWS),
    "PGM as text": as_text(ROWS),
    "PNG": encoded("PNG"),
    "PNG in colours": encoded("PNG", "RGB"),
    "PNG with a palette": encoded("PNG", "P"),
    "PNG with opacity": encoded("PNG", "RGBA"),
    "BMP": encoded("BMP"),
    "BMP in colours": encoded("BMP", "RGB"),
}


@pytest.mark.parametrize("kind", IMAGES)
def test_images_of_all_kinds_are_read_and_refused_when_cut_short(kind: str, tmp_path: Path) -> None:
    image = IMAGES[kind]
    path = tmp_path / "scan.pgm"
    path.write_bytes(image)
    whole = read_map_image(path)
    assert (whole.width, whole.height) == (12, 10)
    assert whole.pixels == read_pixels(tmp_path)
    assert whole.opacity in (b"", b"\xff" * 120)
    # The last 24 bytes are checksums and the end of a PNG, and the end of a number and a comment in an image as text.
    for length in range(2, len(image) - 24, 7):
        path.write_bytes(image[:length])
        assert refusal(path, read_map_image) in (DAMAGED, NO_IMAGE)


def read_pixels(folder: Path) -> bytes:
    path = folder / "plain.pgm"
    path.write_bytes(IMAGES["PGM"])
    return read_map_image(path).pixels


@pytest.mark.parametrize(
    ("image", "sentence"),
    [
        (b"", NO_IMAGE),
        (b"GIF89a", NO_IMAGE),
        (b"\xff\xd8\xff", NO_IMAGE),
        (b"\x89PNG\r\n\x1a\n", NO_IMAGE),
        (b"P5 2", DAMAGED),
        (b"P5 0 2 255\n", NO_IMAGE),
        (b"Pf 1 1 -1\n\0\0\0\0", DAMAGED),
        (b"P2 2 1 255\n0 256\n", DAMAGED),
        (b"P2 2 1 255\n0 -1\n", DAMAGED),
        (b"P5 9999 9999 255\n", "scan.pgm has 9999 by 9999 pixels; a map can have at most 16000000 in all."),
        (b"P5 99999 99999 255\n", "scan.pgm is too large to be a map."),
    ],
)  # fmt: skip
def test_images_that_are_none(image: bytes, sentence: str, tmp_path: Path) -> None:
    path = tmp_path / "scan.pgm"
    path.write_bytes(image)
    assert refusal(path, read_map_image) == sentence


@pytest.mark.parametrize(
    "image",
    [b"P2 3 1 2\n0 1 2\n", b"P2 3 1 65535\n0 32768 65535\n", b"P5 3 1 65535\n\0\0\x80\0\xff\xff"],
)
def test_levels_of_grey_are_scaled_to_255(image: bytes, tmp_path: Path) -> None:
    path = tmp_path / "scan.pgm"
    path.write_bytes(image)
    assert list(read_map_image(path).pixels) in ([0, 128, 255], [0, 127, 255])
