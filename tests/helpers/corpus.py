"""The corpus of public robots beside a checkout. Tests that read it are skipped if it is missing."""

from __future__ import annotations

from typing import Any

import pytest
import yaml
from folder import CHECKOUT

SHARED = CHECKOUT.parent / "shared"
CORPUS = SHARED / "corpus"

needs_corpus = pytest.mark.skipif(not CORPUS.is_dir(), reason="the corpus of public robots is not beside the checkout")


def roots() -> list[dict[str, Any]]:
    """Return the roots in the index of the corpus; none if there is no corpus."""
    if not CORPUS.is_dir():
        return []
    index = (CORPUS / "index.yaml").read_text(encoding="utf-8")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    return list(yaml.load(index, loader)["roots"])  # noqa: S506 (a safe loader)
