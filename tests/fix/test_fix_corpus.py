"""Fixing a copy of the corpus changes only what the fixes say, and removes the findings that they are for."""

from __future__ import annotations

import json
import re
import shutil
from collections import Counter
from collections.abc import Iterable
from itertools import permutations
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from corpus import CORPUS, needs_corpus
from folder import CHECKOUT, Folder
from sampling import WHOLE, sample

SAMPLE = {
    "RafBerkvens__ua_ros_p3dx": 5,
    "RethinkRobotics__baxter_common": 32,
    "davetcoleman__clam": 8,
    "linorobot__linorobot2": 3,
    "PickNikRobotics__ros2_robotiq_gripper": 2,
    "manelpuig__ROS2_my_robot_arm_ws": 5,
}
"""Some repositories that have much to fix, and how many findings of each are fixed at least."""


def repositories() -> list[str]:
    if not WHOLE or not CORPUS.is_dir():
        return sample(SAMPLE, 3)
    bad = [f"known_bad/{path.name}" for path in (CORPUS / "known_bad").iterdir() if path.is_dir()]
    return sorted([*(path.name for path in CORPUS.iterdir() if path.is_dir() and path.name != "known_bad"), *bad])


@pytest.mark.parametrize(
    "source",
    [
        pytest.param(CHECKOUT / "samples/broken/mybot", id="mybot"),
        *(pytest.param(CORPUS / name, id=name, marks=needs_corpus) for name in repositories()),
    ],
)
def test_only_what_the_fixes_say_changes_and_what_they_are_for_is_gone(source: Path, folder: Folder) -> None:
    shutil.copytree(source, folder.path, dirs_exist_ok=True, copy_function=shutil.copyfile)
    before, fixed = contents(folder.path), folder.run("lint", *WORDS, "--unsafe-fixes", "--format", "json=after.json")
    assert fixed.returncode == 0, fixed.stderr
    changed = {path: data for path, data in contents(folder.path).items() if before.get(path) != data}
    findings, left = linted_before(folder, before, set(changed)), reported(folder)
    for path, data in changed.items():
        assert re.fullmatch(pattern(before[path], edits_in(path, findings)), data, re.DOTALL), path
    assert keys(left) <= keys(findings), "findings came"
    gone = keys(findings) - keys(left)
    told = re.search(r"fixed (\d+) of (\d+) findings? in (\d+) files?\n\Z", fixed.stderr)
    assert told is not None
    assert [int(number) for number in told.groups()] == [gone.total(), len(findings), len(changed)]
    assert gone.total() >= SAMPLE.get(source.name, 0)
    assert all(f" {finding['code']} is not fixed: " in fixed.stderr for finding in left if edits_of(finding))


WORDS = (".", "--workspace", ".", "--exit-zero", "--jobs", "1")
Found = dict[str, Any]


def contents(folder: Path) -> dict[str, bytes]:
    """All files but the reports, by their path from the folder on."""
    files = (path for path in folder.rglob("*") if path.is_file() and path.suffix != ".json")
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def linted_before(folder: Folder, before: dict[str, bytes], changed: set[str]) -> list[Found]:
    """The findings in the files as they were; the folder is left so."""
    folder.write({path: before[path] for path in changed})
    (folder.path / "after.json").rename(folder.path / "kept.json")
    folder.run("lint", *WORDS, "--format", "json=after.json")
    found = reported(folder)
    (folder.path / "kept.json").rename(folder.path / "after.json")
    return found


def reported(folder: Folder) -> list[Found]:
    return list(json.loads((folder.path / "after.json").read_text(encoding="utf-8"))["findings"])


def keys(findings: Iterable[Found]) -> Counter[tuple[str, str]]:
    return Counter((finding["code"], finding["file"]) for finding in findings)


# -- what edits may make of a file -----------------------------------------------------------------------------------


class Edit(NamedTuple):
    start: int
    end: int
    text: bytes


def edits_of(finding: Found) -> list[Found]:
    return list((finding.get("fix") or {}).get("edits", ()))


def edits_in(path: str, findings: Iterable[Found]) -> list[Edit]:
    """The edits of a file that the findings ask for, in order, each once."""
    edits = (edit for finding in findings for edit in edits_of(finding) if edit["file"] == path)
    return sorted({Edit(edit["start"], edit["end"], edit["text"].encode()) for edit in edits})


def pattern(data: bytes, edits: Iterable[Edit]) -> bytes:
    """What a file may be after some of the edits were made, each of them wholly or not at all."""
    parts, position = [], 0
    groups: list[list[Edit]] = []
    for edit in edits:
        near = groups[-1] if groups else []
        if any(edit.start < other.end or edit[:2] == other[:2] for other in near):
            groups[-1].append(edit)
        else:
            groups.append([edit])
    for group in groups:
        start, end = group[0].start, max(edit.end for edit in group)
        made = [data[start : edit.start] + edit.text + data[edit.end : end] for edit in group]
        if start == end:  # what is inserted at one place may all be, one run after the other
            made = [b"".join(some) for n in range(1, len(group) + 1) for some in permutations(made, n)]
        parts += [re.escape(data[position:start]), b"(?:", b"|".join(map(re.escape, [data[start:end], *made])), b")"]
        position = end
    return b"".join([*parts, re.escape(data[position:])])


def test_the_pattern_admits_what_the_edits_make_and_nothing_else() -> None:
    edits = [Edit(1, 2, b"X"), Edit(3, 3, b"Y"), Edit(3, 3, b"Z"), Edit(4, 6, b"")]
    admitted = [
        text
        for text in (b"abcdefg", b"aXcdefg", b"aXcYdg", b"abcZdefg", b"abcZYdefg")
        if re.fullmatch(pattern(b"abcdefg", edits), text)
    ]
    assert len(admitted) == 5
    assert not any(re.fullmatch(pattern(b"abcdefg", edits), text) for text in (b"abcdef", b"aXXcdefg", b"abcYYdefg"))
