"""Ten thousand random edits: nothing is raised, and each thirtieth time the live findings are compared with lint's."""

from __future__ import annotations

from pathlib import Path

import pytest
from corpus import CORPUS
from folder import CHECKOUT
from live_replay import copied, differences

FOLDERS = [CHECKOUT / "samples", *sorted(path for path in CORPUS.glob("*__*"))]
EDITS = 10_000
EVERY = 30


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_after_random_edits_nothing_is_missed(folder: Path, tmp_path: Path) -> None:
    assert list(differences(copied(folder, tmp_path), edits=EDITS // len(FOLDERS), seed=1, every=EVERY)) == []
