"""The thread that lints while the user types: always the newest texts, first what is near the change."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Sequence

from urdfctl.errors import UserError
from urdfctl.lint.live import Outdated
from urdfctl.server.analysis.folders import folder_of
from urdfctl.server.analysis.workspace import Checked, Workspace

_log = logging.getLogger(__name__)
Publish = Callable[[Checked, bool, int], None]
"""Takes the findings of a folder, whether all folders are linted now, and how many changes they include."""
SETTLING = 0.03
"""Seconds without a change before linting begins: keys that are pressed together are linted together."""


class Checking:
    """Lints the folders of a window in a thread of its own, again after each change.

    open_workspaces: returns the folders, at least one; it is given what tells them that a text has changed meanwhile.
    publish: called in that thread.
    """

    def __init__(self, open_workspaces: Callable[[Callable[[], bool]], Sequence[Workspace]], publish: Publish) -> None:
        self._publish = publish
        self._changed = threading.Condition()
        self._changes: list[Callable[[Workspace], None]] = []
        self._near: str | None = None
        self._asked = self._made = 0
        self._is_stale = False
        self._ended = False
        self.workspaces = open_workspaces(self._is_outdated)
        self._thread = threading.Thread(target=self._run, name="lint", daemon=True)

    def start(self) -> None:
        """Begin to lint."""
        self._is_stale = True
        self._thread.start()

    def change(self, change: Callable[[Workspace], None], near: str | None = None) -> int:
        """Make a change in each folder before the next linting; return how many changes there are with it.

        near: the file that the user looks at; its package is linted first.
        """
        with self._changed:
            self._changes.append(change)
            self._asked += 1
            self._near = near or self._near
            self._changed.notify()
            return self._asked

    def workspace_of(self, path: str) -> Workspace:
        """Return the folder that a file belongs to: that around it, otherwise the first one that reads the file."""
        around = folder_of(path, [workspace.folder for workspace in self.workspaces])
        candidates = [one for one in self.workspaces if (one.folder == around if around else one.reads(path))]
        return next(iter(candidates), self.workspaces[0])

    def end(self) -> None:
        """End the thread after what it lints."""
        with self._changed:
            self._ended = True
            self._changed.notify()

    def _is_outdated(self) -> bool:
        return bool(self._changes) or self._ended

    def _run(self) -> None:
        while True:
            with self._changed:
                if not (self._changes or self._is_stale or self._ended):
                    self._changed.wait()
                while self._changed.wait(SETTLING):
                    pass
                if self._ended:
                    return
                changes, self._changes = self._changes, []
            for change in changes:
                for workspace in self.workspaces:
                    self._make(change, workspace)
            self._made += len(changes)
            self._is_stale = not self._lint(self._near)

    @staticmethod
    def _make(change: Callable[[Workspace], None], workspace: Workspace) -> None:
        try:
            change(workspace)
        except Exception:  # noqa: BLE001 (a crash must not end the thread)
            _log.exception("urdfctl: a change in '%s' cannot be taken", workspace.folder)

    def _lint(self, near: str | None) -> bool:
        """Lint everything; return whether nothing changed meanwhile."""
        try:
            if near is not None:
                self._check(self.workspace_of(near), near)
            for workspace in self.workspaces:
                self._check(workspace)
        except Outdated:
            return False
        return True

    def _check(self, workspace: Workspace, near: str | None = None) -> None:
        """Lint a folder, or only what is near a file of it, and publish the findings."""
        is_last = near is None and workspace is self.workspaces[-1]
        try:
            checked = workspace.check(near)
        except UserError:  # the folder is gone, for example; the next change tries again
            checked = Checked.nothing(workspace.folder)
        except Outdated:
            raise
        except Exception:  # noqa: BLE001 (a crash must not end the thread)
            _log.exception("urdfctl: '%s' cannot be linted", workspace.folder)
            checked = Checked.nothing(workspace.folder)
        self._publish(checked, is_last, self._made)
