"""A Rosy behind a proxy with TLS: which names, origins and clients it believes, and that it is no private one."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rosy_sim.config import Config
from rosy_sim.errors import BadInput
from rosy_sim.web import server as serving
from rosy_sim.web.public_address import public_names, with_public_address


@pytest.mark.parametrize(
    ("url", "public", "name"),
    [
        ("https://rosy.example", "https://rosy.example", "rosy.example"),
        ("https://Rosy.Example/", "https://rosy.example", "rosy.example"),
        ("https://rosy.example.:443", "https://rosy.example", "rosy.example"),
        ("https://rosy.example:8443", "https://rosy.example:8443", "rosy.example"),
        ("https://[2001:db8::1]", "https://[2001:db8::1]", "2001:db8::1"),
    ],
)
def test_a_public_address_names_the_host_the_origin_and_the_proxy(
    url: str, public: str, name: str, config: Config
) -> None:
    found = with_public_address(config, url)
    assert (found.public, set(public_names(found))) == (public, {name})
    assert found.origins == {public.removeprefix("https://")}
    assert found.proxies == ("127.0.0.1", "::1")


def test_proxies_that_are_named_are_the_only_ones(config: Config) -> None:
    assert with_public_address(replace(config, proxies=("192.0.2.1",)), "https://a.example").proxies == ("192.0.2.1",)


@pytest.mark.parametrize(
    "url",
    [
        "", "rosy.example", "http://rosy.example", "https://", "https://rosy.example/rosy", "https://a@rosy.example",
        "https://rosy.example?x", "https://rosy.example#x", "https://[", "https://rosy.example:port",
    ],
)  # fmt: skip
def test_what_is_no_address_is_refused_with_an_example(url: str, config: Config) -> None:
    with pytest.raises(BadInput, match=r"--public takes the address that others open, such as https://rosy\.example"):
        with_public_address(config, url)


def test_without_a_public_address_no_other_name_is_served(config: Config) -> None:
    assert not public_names(config)


def test_a_public_rosy_without_its_sandbox_is_refused_though_only_the_proxy_reaches_it(config: Config) -> None:
    with pytest.raises(BadInput, match="cannot be locked in on this machine"):
        serving.serve(
            with_public_address(config, "https://rosy.example"), "127.0.0.1", 0, open_browser=False, unprotected=False
        )
