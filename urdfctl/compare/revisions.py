"""Lay out the files of a git revision, without touching the repository or its work tree."""

from __future__ import annotations

import os
import subprocess

from urdfctl.errors import UserError
from urdfctl.names import did_you_mean

_NOT_READ = (
    ".stl",
    ".dae",
    ".obj",
    ".glb",
    ".gltf",
    ".ply",
    ".png",
    ".jpg",
    ".jpeg",
    ".tif",
    ".bag",
    ".mp4",
    ".gif",
    ".zip",
)
"""Files of these kinds are laid out empty: only whether they exist matters."""
_HARMLESS = [
    word
    for setting in ("core.fsmonitor=false", "core.hooksPath=", "filter.lfs.smudge=", "filter.lfs.required=false")
    for word in ("-c", setting)
]
"""Settings of git that keep a repository from running programs of its own, or loading large files."""


def is_revision(word: str) -> bool:
    """Return whether a word is a revision with a path, such as `HEAD~1:urdf/robot.xacro` or `origin/main:`."""
    revision, colon, _ = word.partition(":")
    return bool(colon and revision) and not os.path.exists(word) and not os.path.splitdrive(word)[0]


def repository_of(folder: str) -> str:
    """Return the top folder of the repository around a folder. UserError if there is none."""
    ran = _git(folder, ["rev-parse", "--show-toplevel"])
    if ran.returncode != 0:
        raise UserError(f"'{folder}' is in no git repository")
    return os.path.realpath(ran.stdout.strip())


def lay_out(repository: str, revision: str, folder: str) -> None:
    """Write the files of a revision into an empty folder. UserError if there is no such revision."""
    found = _git(repository, ["rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}"])
    if found.returncode != 0:
        known = _git(repository, ["for-each-ref", "--format=%(refname:short)"]).stdout.split()
        raise UserError(f"git revision '{revision}' does not exist{did_you_mean(revision, known)}")
    listed = _git(repository, ["ls-tree", "-r", "-z", "--name-only", "--full-tree", found.stdout.strip()])
    names = [name for name in listed.stdout.split("\0") if name]
    environment = {**os.environ, "GIT_INDEX_FILE": os.path.join(folder, ".git-index")}
    _git(repository, ["read-tree", found.stdout.strip()], environment=environment)
    read = "\0".join(name for name in names if not name.lower().endswith(_NOT_READ))
    written = _git(
        repository, ["checkout-index", "-z", "--stdin", f"--prefix={folder}/"], environment=environment, text=read
    )
    if written.returncode != 0:
        raise UserError(f"git revision '{revision}' cannot be read: {written.stderr.strip().splitlines()[-1]}")
    for name in names:
        if name.lower().endswith(_NOT_READ):
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            open(path, "wb").close()


def _git(
    folder: str, words: list[str], *, environment: dict[str, str] | None = None, text: str = ""
) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(  # noqa: S603
            ["git", "-C", folder, *_HARMLESS, *words],  # noqa: S607
            env=environment,
            input=text,
            capture_output=True,
            encoding="utf-8",
            errors="surrogateescape",
            check=False,
        )
    except FileNotFoundError:
        raise UserError("git is not installed; without it, no revisions can be compared") from None
