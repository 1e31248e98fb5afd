"""Many words of many robots are replaced by what is offered in their places.

URDFCTL_TREES names further folders of robots, with colons between them: each of their folders is a workspace.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

pytest.importorskip("pygls", reason="pygls is not installed")

from completing import Insertion, insertions
from corpus import CORPUS
from folder import CHECKOUT
from live_replay import copied

_TREES = [Path(path) for path in os.environ.get("URDFCTL_TREES", "").split(":") if path]
FOLDERS = [
    *sorted(path for path in (CHECKOUT / "samples").iterdir() if (path / "package.xml").is_file()),
    *sorted(CORPUS.glob("*__*")),
    *sorted(path for tree in _TREES for path in tree.iterdir() if path.is_dir()),
]
WORDS = 60
MOST_HARMFUL = 0.05
"""The share of items that may cause a finding: texts in expressions whose meaning a name does not show."""


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_inserting_what_is_offered_causes_no_finding(folder: Path, tmp_path: Path) -> None:
    found = list(insertions(copied(folder, tmp_path), number=WORDS, seed=1, each=3))
    harmful = list(filter(Insertion.is_harmful, found))
    sure = [one for one in harmful if one.kind != "property"]
    assert list(map(str, sure)) == []
    assert len(harmful) <= MOST_HARMFUL * len(found), list(map(str, harmful))
