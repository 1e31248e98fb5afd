"""The thread that lints while the user types: always the newest texts, first what is near the change."""

from __future__ import annotations

import threading
from collections.abc import Callable

from urdfctl.errors import UserError
from urdfctl.lint.live import Outdated
from urdfctl.server.workspace import Checked, Workspace

Publish = Callable[[Checked, bool, int], None]
"""Takes the findings, whether they are those of the whole folder, and how many changes they include."""
SETTLING = 0.03
"""Seconds without a change before linting begins: keys that are pressed together are linted together."""


class Checking:
    """Lints a workspace in a thread of its own, again after each change.

    publish: called in that thread.
    Raises UserError if the workspace cannot be opened, as for a wrong configuration.
    """

    def __init__(self, open_workspace: Callable[[Callable[[], bool]], Workspace], publish: Publish) -> None:
        self._publish = publish
        self._changed = threading.Condition()
        self._changes: list[Callable[[Workspace], None]] = []
        self._near: str | None = None
        self._made = 0
        self._is_stale = False
        self._ended = False
        self.workspace = open_workspace(self._is_outdated)
        self._thread = threading.Thread(target=self._run, name="lint", daemon=True)

    def start(self) -> None:
        """Begin to lint."""
        self._is_stale = True
        self._thread.start()

    def change(self, change: Callable[[Workspace], None], near: str | None = None) -> None:
        """Make a change before the next linting. near: the file that the user looks at; its package is linted first."""
        with self._changed:
            self._changes.append(change)
            self._near = near or self._near
            self._changed.notify()

    def end(self) -> None:
        """End the thread after what it lints."""
        with self._changed:
            self._ended = True
            self._changed.notify()

    def _is_outdated(self) -> bool:
        return bool(self._changes) or self._ended

    def _run(self) -> None:
        while not self._ended:
            with self._changed:
                if not (self._changes or self._is_stale):
                    self._changed.wait()
                while self._changed.wait(SETTLING):
                    pass
                changes, self._changes = self._changes, []
            for change in changes:
                change(self.workspace)
            self._made += len(changes)
            self._is_stale = not self._lint(self._near)

    def _lint(self, near: str | None) -> bool:
        """Lint everything; return whether nothing changed meanwhile."""
        try:
            if near is not None:
                self._publish(self.workspace.check(near), False, self._made)  # noqa: FBT003
            self._publish(self.workspace.check(), True, self._made)  # noqa: FBT003
        except Outdated:
            return False
        except UserError:  # the folder is gone, for example; the next change tries again
            pass
        return True
