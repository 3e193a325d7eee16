"""What was built goes out small, and only once: compressed twins, and what a browser may keep."""

from __future__ import annotations

import asyncio
import gzip
import os
from pathlib import Path

import httpx
import pytest

from rosy_sim.web.static_pages import StaticPages

TEXT = "let robot = 'Kobuki';\n" * 100


@pytest.fixture
def built(tmp_path: Path) -> Path:
    """A page and one asset, each with its twin."""
    (tmp_path / "assets").mkdir()
    for name in ("index.html", "assets/index-B2D3HhZd.js"):
        file = tmp_path / name
        file.write_text(TEXT)
        twin = tmp_path / f"{name}.gz"
        twin.write_bytes(gzip.compress(TEXT.encode()))
        os.utime(twin, ns=(file.stat().st_mtime_ns, file.stat().st_mtime_ns))
    return tmp_path


def get(folder: Path, path: str, **headers: str) -> httpx.Response:
    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(StaticPages(directory=folder, html=True))
        async with httpx.AsyncClient(transport=transport, base_url="http://rosy") as client:
            return await client.get(path, headers={"accept-encoding": "identity", **headers})

    return asyncio.run(ask())


GZIP = {"accept-encoding": "deflate, gzip;q=0.8"}


@pytest.mark.parametrize("taken", ["gzip", "deflate, gzip;q=0.8", "gzip; q=0.001, br;q=0"])
def test_a_browser_gets_the_twin(taken: str, built: Path) -> None:
    answer = get(built, "/assets/index-B2D3HhZd.js", **{"accept-encoding": taken})
    assert answer.text == TEXT
    assert answer.headers["content-encoding"] == "gzip"
    assert int(answer.headers["content-length"]) < len(TEXT) / 10
    assert answer.headers["content-type"].startswith("text/javascript")
    assert answer.headers["vary"] == "Accept-Encoding"


@pytest.mark.parametrize("taken", ["identity", "gzip;q=0", "br, GZIP ; Q=0.000, deflate", "x-gzip", ""])
def test_who_takes_no_gzip_gets_the_file(taken: str, built: Path) -> None:
    answer = get(built, "/assets/index-B2D3HhZd.js", **{"accept-encoding": taken})
    assert answer.text == TEXT
    assert "content-encoding" not in answer.headers
    assert answer.headers["vary"] == "Accept-Encoding"


def test_a_twin_of_what_the_file_was_before_is_not_sent(built: Path) -> None:
    file = built / "index.html"
    file.write_text("new")
    os.utime(file, ns=(file.stat().st_atime_ns, (built / "index.html.gz").stat().st_mtime_ns + 1))
    answer = get(built, "/", **GZIP)
    assert answer.text == "new"
    assert "vary" not in answer.headers


def test_an_asset_is_kept_and_a_page_is_asked_for(built: Path) -> None:
    asset = get(built, "/assets/index-B2D3HhZd.js", **GZIP)
    assert asset.headers["cache-control"] == "public, max-age=31536000, immutable"
    page = get(built, "/", **GZIP)
    assert page.headers["cache-control"] == "no-cache"
    again = get(built, "/", **GZIP, **{"if-none-match": page.headers["etag"]})
    assert again.status_code == 304
    assert again.content == b""
