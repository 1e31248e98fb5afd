"""A git that lists files with the names of an input, in place of the real one."""

from __future__ import annotations

import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from random import Random

from urdfctl.compare import revisions
from urdfctl.run import git

_KEY = b"5716ca5987cbf97d6bb54920bea6adde242d87e6"
_MODES = [b"100644 blob", b"100644 blob", b"100755 blob", b"120000 blob", b"160000 commit"]
LISTING = b"urdf/arm.xacro\0run.sh\0link.urdf\0module\0meshes/part.stl\0a b\n.yaml"
_LARGEST = 1 << 40


class _Answers:
    """A process of git: what it prints, and the lines that it answers. The sizes and contents of objects are random."""

    def __init__(self, data: bytes, random: Random) -> None:
        self.answers = BytesIO(data)
        self._random = random

    def answer(self, _: str) -> bytes:
        content = self._random.choice([b"<a/>", b"../../secret", b"/etc", b"urdf", b"", b"\0" * 5000])
        self.answers = BytesIO(content + b"\n")
        is_there = b"%s blob %d\n" % (_KEY, len(content))
        return self._random.choice([is_there] * 100 + [_KEY + b" missing\n", b"%s blob %d\n" % (_KEY, _LARGEST)])

    def status(self) -> int:
        return 0

    def why(self) -> str:
        return ""

    def check(self) -> None:
        return None


def laid_out(data: bytes, random: Random) -> None:
    """Lay out a revision whose files have the names in an input, between zeros."""
    names = data.split(b"\0")
    listing = b"".join(b"%s %s\t%s\0" % (random.choice(_MODES), _KEY, name) for name in names)

    @contextmanager
    def started(_: str, words: Sequence[str], __: Sequence[str] = ()) -> Iterator[_Answers]:
        yield _Answers(listing if words[0] == "ls-tree" else _KEY, random)

    folder, before = Path("laid_out").resolve(), git.started_git
    folder.mkdir()
    git.started_git = started
    try:
        revisions.lay_out(".", "main", str(folder))
    finally:
        git.started_git = before
        shutil.rmtree(folder)
