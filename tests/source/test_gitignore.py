"""What git ignores is not looked for in folders, and git itself says what that is."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from folder import Folder
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sampling import examples
from work import assert_linear

from urdfctl.discover.robots import discover_files
from urdfctl.source.disk.gitignore import GitIgnore, patterns_of

ROBOT = "<robot name='r'><link name='a'/><link name='b'/></robot>"
needs_git = pytest.mark.skipif(shutil.which("git") is None, reason="git is not here")
NAMES = ("a", "b", "ab", "a.b", "aab")
PATHS = [
    *NAMES,
    *(f"{one}/{other}" for one in NAMES for other in NAMES),
    "a/b/a",
    "a/b/ab",
    "a/a/b",
    "b/a/a/b",
    "ab/a/a/a",
]
# not `a**`: of a star twice within a name git makes other things than its manual says
PARTS = st.sampled_from(
    [
        "a",
        "b",
        "ab",
        "a.b",
        "*",
        "**",
        "?",
        "a*",
        "*b",
        "a?",
        "[ab]",
        "[!a]",
        "[^a]",
        "a[ab]b",
        "\\a",
        "\\*",
        "***",
    ]
)
LINES = st.builds(
    lambda mark, start, parts, end: mark + start + "/".join(parts) + end,
    st.sampled_from(["", "", "", "!", "#", "\\!", "\\#"]),
    st.sampled_from(["", "", "/"]),
    st.lists(PARTS, min_size=1, max_size=4),
    st.sampled_from(["", "", "/", " ", "\\ ", "\r"]),
)


def ignored(folder: str | Path, paths: list[str]) -> set[str]:
    """Those of some paths that are not looked at, as one goes down from a folder."""
    git = GitIgnore(str(folder))

    def is_ignored(path: str) -> bool:
        parts = path.split("/")
        return any(
            git.ignores(os.path.join(folder, *parts[:size]), is_folder=size < len(parts))
            for size in range(1, len(parts) + 1)
        )

    return {path for path in paths if is_ignored(path)}


@needs_git
@settings(max_examples=examples(40), suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(top=st.lists(LINES, max_size=4), below=st.lists(LINES, max_size=2), shared=st.lists(LINES, max_size=1))
def test_what_is_ignored_is_what_git_says(top: list[str], below: list[str], shared: list[str], tmp_path: Path) -> None:
    if not (tmp_path / ".git").is_dir():
        subprocess.run(["git", "init", "--quiet", str(tmp_path)], check=True)
    (tmp_path / ".gitignore").write_bytes("\n".join(top).encode())
    (tmp_path / "a").mkdir(exist_ok=True)
    (tmp_path / "a" / ".gitignore").write_bytes("\n".join(below).encode())
    (tmp_path / ".git/info/exclude").write_bytes("\n".join(shared).encode())
    paths = [path for path in PATHS if path != "a"]
    command = ["git", "-c", "core.excludesFile=", "-c", "core.quotePath=false", "check-ignore", "--no-index", "--stdin"]
    ran = subprocess.run(command, input="\n".join(paths), capture_output=True, text=True, cwd=tmp_path, check=False)
    assert ran.stderr == ""
    assert ignored(tmp_path, paths) == set(ran.stdout.splitlines())


@pytest.mark.parametrize(
    ("line", "path", "expected"),
    [
        ("*.urdf", "deep/down/r.urdf", True),
        ("/r.urdf", "deep/r.urdf", False),
        ("deep/r.urdf", "deep/r.urdf", True),
        ("deep/**/r.urdf", "deep/a/b/r.urdf", True),
        ("deep/**/r.urdf", "deep/r.urdf", True),
        ("deep/**", "deep", False),
        ("generated/", "generated", False),
        ("generated/", "generated/r.urdf", True),
        ("\\#r.urdf", "#r.urdf", True),
        ("größe.urdf", "größe.urdf", True),
    ],
)
def test_a_pattern_means_what_it_does_in_git(folder: Folder, line: str, path: str, expected: bool) -> None:
    folder.write({".git/HEAD": "", ".gitignore": f"\ufeff{line}\n"})
    assert (ignored(folder.path, [path]) == {path}) == expected


def test_folders_are_searched_without_what_git_ignores_but_a_file_may_be_named(folder: Folder) -> None:
    names = ["r.urdf", "generated/r.urdf", "sub/made.urdf", "sub/kept.urdf", "sub/deep/r.yaml"]
    ignore = {".gitignore": "generated/\n", "sub/.gitignore": "*.urdf\n!kept.urdf\ndeep\n"}
    folder.write({".git/HEAD": "", **dict.fromkeys(names, ROBOT), **ignore})
    assert discover_files(["."]).candidates == ["./r.urdf", "./sub/kept.urdf"]
    assert discover_files(["sub"]).candidates == ["sub/kept.urdf"]
    assert discover_files(["sub/made.urdf"]).robots == ["sub/made.urdf"]


def test_without_a_repository_nothing_is_ignored(folder: Folder) -> None:
    folder.write({".gitignore": "*\n", "r.urdf": ROBOT})
    assert discover_files(["."]).candidates == ["./r.urdf"]


def test_a_link_that_leads_out_of_the_repository_is_not_gits(folder: Folder) -> None:
    folder.write({"mine/.git/HEAD": "", "mine/.gitignore": "*\n", "theirs/r.urdf": ROBOT})
    os.symlink("../theirs", "mine/link")
    git = GitIgnore("mine")
    assert git.ignores("mine/link", is_folder=True)
    assert not git.ignores("mine/link/r.urdf", is_folder=False)


def test_many_stars_take_work_in_proportion_to_the_length_of_a_path() -> None:
    [pattern] = patterns_of("/" + "**/a*a*a*a*b/" * 20 + "c")

    def match(parts: int) -> None:
        assert not pattern.matches(["a" * 200] * parts, is_folder=False)

    assert_linear(match, 50)
