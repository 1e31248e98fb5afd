"""What a command answers: printed as it goes along for a person, or kept, to be one object for a program."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum
from typing import Any

from urdfctl.output.printing import print_message, print_text


class FileState(Enum):
    """What a command did to a file, or found of it."""

    WRITTEN = "written"
    UNCHANGED = "unchanged"
    OUT_OF_DATE = "out of date"
    SKIPPED = "skipped"


class CommandAnswer:
    """What a command says, makes and advises.

    is_kept: nothing is printed; `document` has all of it.
    """

    def __init__(self, *, is_kept: bool = False) -> None:
        self.is_kept = is_kept
        self.lines: list[str] = []
        self.files: dict[str, dict[str, str]] = {}
        self._steps: list[str] = []
        self._text = ""
        self._more: dict[str, Any] = {}

    def message(self, line: str) -> None:
        """Say something about the run."""
        if self.is_kept:
            self.lines.append(line)
        else:
            print_message(line)

    def messages(self, lines: Iterable[str]) -> None:
        """Say several things."""
        for line in lines:
            self.message(line)

    def next(self, step: str) -> None:
        """Say what to do now: a command, or a line for a file."""
        if self.is_kept:
            self._steps.append(step)
        else:
            print_message(f"next: {step}")

    def text(self, text: str) -> None:
        """Give the text that the command is asked for."""
        if self.is_kept:
            self._text += text
        else:
            print_text(text)

    def file(self, path: str, state: FileState, **more: str) -> None:
        """Keep what happened to a file: its `diff`, or the `reason`. A person is told by a message, if at all."""
        self.files[path] = {"path": path, "state": state.value, **more}

    def out_of_date(self, path: str, diff: str = "") -> None:
        """Say that a file would change, and how."""
        self.file(path, FileState.OUT_OF_DATE, **({"diff": diff} if diff else {}))
        if not self.is_kept:
            print_text(diff or f"{path} is out of date\n")

    def add(self, **more: Any) -> None:
        """Keep what only this command has to say to a program."""
        self._more |= more

    def document(self, command: str, status: int) -> dict[str, Any]:
        """Return all that was kept as plain data; answer.schema.json is its schema."""
        return {
            "version": 1,
            "command": command,
            "status": status,
            "messages": self.lines,
            "files": list(self.files.values()),
            "next": self._steps,
            **({"text": self._text} if self._text else {}),
            **self._more,
        }
