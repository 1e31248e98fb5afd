"""The editor gets what migrate would change as edits: those of the diff that the command prints."""

from __future__ import annotations

import os

from hypothesis import given
from hypothesis import strategies as st

from urdfctl.output.change import Change
from urdfctl.output.patch import patch
from urdfctl.server.commands.patches import read_patch

LINES = [
    "a\n",
    "b\n",
    "c\r\n",
    "--- x\n",
    "+++ y\n",
    "@@ -1 +1 @@\n",
    "\\ No newline\n",
    "diff --git a/x b/x\n",
    "a",
    "\n",
]
TEXTS = st.none() | st.lists(st.sampled_from(LINES), max_size=12).map(lambda lines: "".join(lines).encode())
NAMES = st.sampled_from(["x.yaml", "a b/c.xml", 'we"ird\t\\.x', "ü.urdf"])


@given(st.lists(st.tuples(NAMES, TEXTS, TEXTS), max_size=3, unique_by=lambda change: change[0]))
def test_a_diff_is_read_as_it_was_meant(given_changes: list[tuple[str, bytes | None, bytes | None]]) -> None:
    changes = [
        Change(os.path.join(os.path.realpath(os.curdir), name), before, after)
        for name, before, after in given_changes
        if before != after
    ]
    files = read_patch(patch(changes))
    assert [os.fsdecode(file.path) for file in files] == [os.path.relpath(change.file) for change in changes]
    for file, change in zip(files, changes, strict=True):
        assert file.applied(change.before or b"") == (change.after or b"")
        assert (file.is_new, file.is_deleted) == (change.before is None, change.after is None)
