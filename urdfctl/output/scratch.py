"""Folders for what is needed during one run only."""

from __future__ import annotations

import tempfile

from urdfctl.output.temporary import END, is_of_this_process, prefix, remove_leftovers
from urdfctl.source.disk.folders import delete_folder
from urdfctl.source.disk.gate import admit


class ScratchFolder(tempfile.TemporaryDirectory[str]):
    """A folder to be deleted by its `cleanup` or as a context, however deeply its folders are nested.

    A worker is a fork with a copy of it: what ends there does not take the folder from the process that made it.
    """

    def cleanup(self) -> None:
        """Delete the folder, if this process made it."""
        if is_of_this_process(self.name):
            delete_folder(self.name)
            super().cleanup()


def scratch_folder() -> ScratchFolder:
    """Return a new folder, which this run may also read; those of killed runs are deleted now."""
    remove_leftovers(tempfile.gettempdir())
    folder = ScratchFolder(prefix=prefix(), suffix=END)
    admit(folder.name)
    return folder
