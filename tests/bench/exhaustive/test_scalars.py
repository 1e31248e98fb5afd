"""Every plain scalar of every YAML file of the corpus, read with both of PyYAML's parsers."""
# ruff: noqa: F401

from __future__ import annotations

from test_yaml import parser, test_every_plain_scalar_of_the_corpus_is_what_its_span_cuts_out
