"""What was made from the files of a copy, remembered while the files that it was made from are the same."""

from __future__ import annotations

import os
from collections.abc import Hashable, Iterable, Iterator, Mapping
from typing import Generic, TypeVar

from urdfctl.migrate.trial.scratch import Scratch, WrittenFile
from urdfctl.startup.records import NamedTuple

Value = TypeVar("Value")
State = Mapping[str, WrittenFile]

_OF_PACKAGES = frozenset({"package.xml", "CMakeLists.txt", "setup.py", "urdfctl.toml", "pyproject.toml"})
"""Files that decide more than what reads them."""


class _Made(NamedTuple):
    """A value, the files that were read for it, and what was written when it was made."""

    value: object
    files: frozenset[str]
    state: State


class Memory(Generic[Value]):
    """Remembers values by a key and by the files that were read for them.

    A value is out of date if a file that was read for it has another content, if files were created or deleted, or if a
    file has another content that nothing is known to read: it may concern everything.

    most: how many states of a key are remembered.
    by_package: whether package.xml and build files concern only what was read in their package: so it is for the model
        of a robot, but lint also looks at those of other packages.
    """

    def __init__(self, scratch: Scratch, most: int = 1, *, by_package: bool = False) -> None:
        self._scratch, self._most, self._by_package = scratch, most, by_package
        self._made: dict[Hashable, list[_Made]] = {}
        self._read: set[str] = set()

    def get(self, key: Hashable) -> Value | None:
        """Return the value for a key that still holds; None if there is none."""
        now = self._scratch.written
        for made in self._made.get(key, ()):
            if made.state is now or self._is_same(made, now):
                return made.value  # type: ignore[return-value]
        return None

    def put(self, key: Hashable, files: Iterable[str], value: Value) -> None:
        """Remember a value that was made from some files as they are now."""
        read = frozenset(path for file in files for path in (file, os.path.realpath(file)))
        self._read |= read
        made = self._made.setdefault(key, [])
        made.insert(0, _Made(value, read, dict(self._scratch.written)))
        del made[self._most :]

    def _is_same(self, made: _Made, now: State) -> bool:
        return dict(self._concerning(made, made.state)) == dict(self._concerning(made, now))

    def _concerning(self, made: _Made, state: State) -> Iterator[tuple[str, object]]:
        """Yield the files whose state may concern a value, with what matters of them."""
        for path, written in state.items():
            folder, name = os.path.split(path)
            if name in _OF_PACKAGES:
                concerns = not self._by_package or any(file.startswith(folder + os.sep) for file in made.files)
            else:
                concerns = path not in self._read or path in made.files
            if concerns:
                yield path, written.after
            elif written.is_new or written.after is None:
                yield path, written.after is None
