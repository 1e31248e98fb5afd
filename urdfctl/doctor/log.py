"""What a log says of a controller, a hardware component or a manager."""

from __future__ import annotations

from collections.abc import Iterable

from urdfctl.errors import UserError
from urdfctl.logs.digest import KnownMessage, digest
from urdfctl.logs.reading import Lines
from urdfctl.source.disk.gate import opened
from urdfctl.startup.records import NamedTuple

_FAR = 6
"""Lines between what failed and what names the controller for which it failed."""


class LoggedFailure(NamedTuple):
    """A line of a log. fix: what to do about it."""

    line: int
    text: str
    fix: str


class Log(NamedTuple):
    """The messages of a log that say what failed, in the order of the lines."""

    failures: tuple[KnownMessage, ...] = ()
    consequences: tuple[KnownMessage, ...] = ()

    def of(self, *names: str) -> LoggedFailure | None:
        """Return the first failure of what is called so, or the one right before a consequence that names it."""
        named = [one for one in self.failures if _names(one, names)]
        if not named:
            lines = [one.line for one in self.consequences if _names(one, names)]
            named = [one for one in self.failures if any(0 < line - one.line <= _FAR for line in lines)]
        return LoggedFailure(named[0].line, named[0].text, named[0].reading.best_fix) if named else None


def _names(message: KnownMessage, names: Iterable[str]) -> bool:
    return any(name in values.values() for values in message.values for name in names)


def log_of(lines: Iterable[str], distro: str | None = None) -> Log:
    """Return what failed in a log."""
    known = sorted(digest(lines, pasted=False, distro=distro).known, key=lambda one: one.line)
    return Log(
        tuple(one for one in known if one.kind == "failure"), tuple(one for one in known if one.kind == "consequence")
    )


def read_log(path: str, distro: str | None = None) -> Log:
    """Return what failed in a log file. Raises UserError if it cannot be read."""
    try:
        with opened(path) as stream:
            return log_of(Lines(stream), distro)
    except OSError as error:
        raise UserError(f"'{path}' cannot be read: {error.strerror}") from None
