"""The folders of an editor's window: which of them a file belongs to, and what is found in the files of all of them."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable

from urdfctl.diagnostic import Diagnostic
from urdfctl.server.analysis.workspace import Checked


def folder_of(path: str, folders: Collection[str]) -> str | None:
    """Return the innermost folder that contains a file; None if none does. All are real paths."""
    around = [folder for folder in folders if path.startswith(folder.rstrip(os.sep) + os.sep)]
    return max(around, key=len, default=None)


class FoundByFolder:
    """The findings in the files of several folders, each linted by itself.

    A file may have findings from several: a robot of one folder includes a file of another. But what is in a folder
    inside of another one is only linted as the inner folder's configuration says.
    """

    def __init__(self, folders: Collection[str]) -> None:
        self._folders = folders
        self._found: dict[str, dict[str, tuple[Diagnostic, ...]]] = {folder: {} for folder in folders}

    def take(self, checked: Checked) -> None:
        """Take what was found in a folder, or in a part of it."""
        known = self._found[checked.folder]
        if checked.is_whole:
            known.clear()
        for file in checked.files:
            known.pop(file, None)
        known.update(checked.findings)

    def files(self) -> set[str]:
        """Return the files with findings."""
        return {file for found in self._found.values() for file in found}

    def of(self, file: str) -> tuple[Diagnostic, ...]:
        """Return the findings in a file."""
        findings: dict[Diagnostic, None] = {}
        for folder in self._speaking(file):
            findings.update(dict.fromkeys(self._found[folder].get(file, ())))
        return tuple(findings)

    def _speaking(self, file: str) -> Iterable[str]:
        """The folders whose findings in a file count: not those around its own folder."""
        own = folder_of(os.path.realpath(file), self._folders)
        return (folder for folder in self._folders if own is None or folder == own or not _is_in(own, folder))


def _is_in(inner: str, outer: str) -> bool:
    return folder_of(inner, [outer]) is not None
