"""Folders for what is needed during one run only."""

from __future__ import annotations

import tempfile

from urdfctl.output.temporary import END, prefix, remove_leftovers
from urdfctl.source.disk.folders import delete_folder
from urdfctl.source.disk.gate import admit


class ScratchFolder(tempfile.TemporaryDirectory[str]):
    """A folder to be deleted by its `cleanup` or as a context, however deeply its folders are nested."""

    def cleanup(self) -> None:
        """Delete the folder."""
        delete_folder(self.name)
        super().cleanup()


def scratch_folder() -> ScratchFolder:
    """Return a new folder, which this run may also read; those of killed runs are deleted now."""
    remove_leftovers(tempfile.gettempdir())
    folder = ScratchFolder(prefix=prefix(), suffix=END)
    admit(folder.name)
    return folder
