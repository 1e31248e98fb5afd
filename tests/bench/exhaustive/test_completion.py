"""Many words of many robots are replaced by what is offered in their places.

URDFCTL_TREES names further folders of robots, with colons between them: each of their folders is a workspace.
"""

from __future__ import annotations

import os
from collections import Counter
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
WORDS = 30
"""Of each kind about two."""
OF_THE_ROBOT = frozenset({"link", "mimicked joint", "part", "element", "macro parameter", "spawner argument"})
"""Names for which the robot decides what fits. What a file, a macro or a text in an expression means, nothing decides
before it is written."""
MOST_HARMFUL = 0.02
_FOUND: list[Insertion] = []


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_a_name_of_the_robot_that_is_offered_causes_no_finding(folder: Path, tmp_path: Path) -> None:
    found = list(insertions(copied(folder, tmp_path), number=WORDS, seed=1, each=3))
    _FOUND.extend(found)
    assert [str(one) for one in found if one.kind in OF_THE_ROBOT and one.is_harmful()] == []


def test_few_of_all_items_cause_a_finding() -> None:
    harmful = list(filter(Insertion.is_harmful, _FOUND))
    counts = {"all": Counter(one.kind for one in _FOUND), "harmful": Counter(one.kind for one in harmful)}
    assert len(harmful) <= MOST_HARMFUL * len(_FOUND), (counts, list(map(str, harmful)))
