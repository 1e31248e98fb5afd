"""A repository with revisions whose trees no well-meaning git writes, and settings that would run programs."""

from __future__ import annotations

import os
import subprocess
import tempfile
from pathlib import Path

from hostile.revisions import TREES
from seeds import ARM

REVISIONS = ["HEAD", "main", "main~1", *TREES, "nowhere", "-x", "main^{tree}", "HEAD:urdf"]
"""Words before the colon of a revision with a path."""
_SETTINGS = {
    "filter.x.smudge": "touch ran",
    "filter.x.required": "true",
    "core.fsmonitor": "touch ran",
    "core.hooksPath": ".",
    "core.pager": "touch ran",
    "diff.external": "touch ran",
    "core.sshCommand": "touch ran",
    "core.alternateRefsCommand": "touch ran",
}
_WHO = {
    **{f"GIT_{who}_{what}": "x@example.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")},
    **{f"GIT_{who}_DATE": "1700000000 +0000" for who in ("AUTHOR", "COMMITTER")},
}


_HELD: list[tempfile.TemporaryDirectory[str]] = []


def repository() -> Path:
    """Return the .git folder of the repository; it is made once, and stays until the process ends."""
    if not _HELD:
        _HELD.append(tempfile.TemporaryDirectory(prefix="urdfctl-fuzz-"))
        _make(Path(_HELD[0].name))
    return Path(_HELD[0].name, ".git")


def _make(folder: Path) -> None:
    _git(folder, "init", "--quiet", "--initial-branch=main")
    manifest = b"<package><name>arm</name></package>"
    commit = ""
    for name, entries in {"older": [], **TREES, "main": []}.items():
        listed = [*entries, ("100644", "urdf/arm.xacro", ARM), ("100644", "package.xml", manifest)]
        before = ["-p", commit] if commit else []
        commit = _git(folder, "commit-tree", *before, "-m", name, _tree(folder, listed)).decode().strip()
        _git(folder, "update-ref", f"refs/heads/{name}", commit)
    for setting, value in _SETTINGS.items():
        _git(folder, "config", setting, value)
    (folder / ".git" / "info").mkdir(exist_ok=True)
    (folder / ".git" / "info" / "attributes").write_text("* filter=x diff=x\n", encoding="utf-8")


def _tree(folder: Path, entries: list[tuple[str, str, bytes]]) -> str:
    """Write a tree with entries as they are, by mode, path and content, and return its name."""
    inner: dict[str, list[tuple[str, str, bytes]]] = {}
    lines = []
    for mode, path, content in entries:
        first, slash, rest = path.partition("/")
        if slash and rest:
            inner.setdefault(first, []).append((mode, rest, content))
        else:
            made = _git(folder, "hash-object", "-w", "--stdin", text=content).decode().strip()
            lines.append((mode, path, made if mode != "160000" else "1" * 40))
    lines += [("40000", name, _tree(folder, below)) for name, below in inner.items()]
    heads = ((f"{mode} {name}\0".encode("utf-8", "surrogateescape"), made) for mode, name, made in lines)
    data = b"".join(head + bytes.fromhex(made) for head, made in heads)
    return _git(folder, "hash-object", "-t", "tree", "-w", "--literally", "--stdin", text=data).decode().strip()


def _git(folder: Path, *words: str, text: bytes = b"") -> bytes:
    environment = {**os.environ, **_WHO, "GIT_CONFIG_NOSYSTEM": "1", "GIT_CONFIG_GLOBAL": os.devnull}
    ran = subprocess.run(["git", "-C", folder, *words], input=text, capture_output=True, env=environment, check=True)
    return ran.stdout
