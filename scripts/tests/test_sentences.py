"""Translations of the worker's sentences: each kind of fault in a template or a table is found."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sentences import sentence_breaches, sentence_ids, service_templates, templates

_FORMS = {"type": "{type}", "function": "{type}", "alternative": " o ", "sequence": ", ", "numbers": []}


def _project(root: Path, source: str, sentences: dict[str, str]) -> Path:
    worker = root / "rosy-hs/worker"
    worker.mkdir(parents=True)
    (worker / "Module.hs").write_text(source)
    tables = root / "languages/xx"
    tables.mkdir(parents=True)
    (tables / "sentences.json").write_text(json.dumps({**_FORMS, "sentences": sentences}))
    return root


def test_the_worker_and_its_tables_have_no_fault() -> None:
    assert list(sentence_breaches()) == []
    assert len(sentence_ids()) > 500


def test_templates_are_read_with_their_arguments() -> None:
    source = """
-- tr "in a comment"
f = tr "A \\"text\\"."
g n = trWith "{a n}, {count m}." ["n" =: quoted ["x]"], "m" =# length n]
h = trWith
  "On two lines: {n}."
  ["n" =: n]
attribute = transform "no call"
"""
    assert list(templates(source)) == [
        (3, 'A "text".', set()),
        (4, "{a n}, {count m}.", {"n", "m"}),
        (5, "On two lines: {n}.", {"n"}),
    ]


@pytest.mark.parametrize(
    ("source", "sentences", "fault"),
    [
        ("f = tr template", {}, "Module.hs:1: write the template"),
        ('f = trWith "{n}." given', {"{n}.": "{n}."}, "Module.hs:1: write the template"),
        ('f = trWith "{n}." ["m" =: x]', {"{n}.": "{n}."}, "do not fit the template"),
        ('f = tr "{n}."', {"{n}.": "{n}."}, "do not fit the template"),
        ('f = tr "One."', {}, "nothing is said for “One.”"),
        ('f = tr "One."', {"One.": ""}, "nothing is said for “One.”"),
        ('f = tr "One."', {"One.": "Uno.", "Two.": "Dos."}, "nothing says “Two.”"),
        ('f = trWith "{n}." ["n" =: x]', {"{n}.": "{m}."}, "has other arguments"),
        ('f = trWith "{n}." ["n" =: x]', {"{n}.": "{the n}."}, "unknown format: the"),
        ('f = trWith "{n}." ["n" =: x]', {"{n}.": "{n} {a  b}."}, "a brace that belongs to no argument"),
    ],
)
def test_a_fault_is_named(tmp_path: Path, source: str, sentences: dict[str, str], fault: str) -> None:
    found = list(sentence_breaches(_project(tmp_path, source, sentences)))
    assert any(fault in breach for breach in found), found


def test_a_table_without_its_forms_is_refused(tmp_path: Path) -> None:
    root = _project(tmp_path, 'f = tr "One."', {})
    (root / "languages/xx/sentences.json").write_text('{"sentences": {"One.": "Uno."}}')
    assert "a table has type, function" in next(sentence_breaches(root))


def test_a_template_of_a_table_has_the_arguments_that_it_names() -> None:
    source = 'from x import template\ntable = {"came": template("{one} came."), "other": template(text)}\nw.template(key)\n'
    assert list(service_templates(source)) == [(2, "{one} came.", {"one"}), (2, None, None)]
