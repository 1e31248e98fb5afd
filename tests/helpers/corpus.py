"""Whole robots: our own, and the corpus of public ones where it lies beside the checkout.

Tests of public robots by name are skipped without the corpus; those of properties run on our own robots everywhere.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import pytest
import yaml
from folder import CHECKOUT

SHARED = CHECKOUT.parent / "shared"
CORPUS = SHARED / "corpus"
OWN = CHECKOUT / "tests" / "corpus"

needs_corpus = pytest.mark.skipif(not CORPUS.is_dir(), reason="the corpus of public robots is not beside the checkout")


def roots() -> list[dict[str, Any]]:
    """Return the roots in the index of the corpus; none if there is no corpus. Paths begin at the corpus."""
    if not CORPUS.is_dir():
        return []
    return _indexed(CORPUS)


def own_roots() -> list[dict[str, Any]]:
    """Return our own robots and the samples, in the form of the corpus; paths are absolute."""
    return [
        {
            "expands": True,
            "args": {},
            **root,
            "id": f"{Path(root['path']).parts[-3]}{number}",
            "path": str(CHECKOUT / root["path"]),
            "controllers": [str(CHECKOUT / path) for path in root["controllers"]],
        }
        for number, root in enumerate(_indexed(OWN))
    ]


def workspace_of(root: dict[str, Any]) -> Path:
    """Return the folder in which the packages of a root are."""
    return next((folder for folder in (OWN, CHECKOUT / "samples") if folder in Path(root["path"]).parents), CORPUS)


@cache
def _indexed(folder: Path) -> list[dict[str, Any]]:
    return list(quick_yaml(folder / "index.yaml")["roots"])


def quick_yaml(path: Path) -> Any:
    """The content of a large file in YAML, by libyaml where it is: modules are imported once for each worker."""
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    return yaml.load(path.read_text(encoding="utf-8"), loader)  # noqa: S506 (a safe loader)
