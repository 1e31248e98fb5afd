"""A fault: all that is known about it, whoever finds it. The decorators and docstrings of functions declare faults."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum
from typing import TYPE_CHECKING

from urdfctl import SITE
from urdfctl.catalog.distros import ALL
from urdfctl.diagnostic import Severity
from urdfctl.model.stage import Stage, StageDependsOn
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from typing_extensions import NotRequired, TypedDict, Unpack

Written = Mapping[str, str]
"""An example as it is declared: files by name, the one to lint first. Under `options`, the options of lint that it
needs instead of those of the fault."""


class Example(NamedTuple):
    """Files that show a fault, or the like without it."""

    files: dict[str, str]
    """By name, the one to lint first. In a bad example, « and » mark the places of the expected findings."""
    options: tuple[str, ...]
    """The options of the command line to lint them with."""


class Runtime(Enum):
    """What ROS, Gazebo or another program does with the faulty part."""

    REFUSES = "refuses"
    """It rejects the part or waits in vain: the robot, a controller or a node does not load, start or move."""
    CRASHES = "crashes"
    """It throws, exits or dies."""
    DROPS = "drops"
    """It goes on without the part that the robot needs to move."""
    IGNORES = "ignores"
    """It goes on without what is written, or with another value, and tells nobody."""
    MISBEHAVES = "misbehaves"
    """It does something else than what was meant."""
    WARNS = "warns"
    """It says so and goes on."""
    WORKS = "works"
    """Nothing is lost in this configuration."""

    @property
    def severities(self) -> tuple[Severity, ...]:
        """The severities that go with it; another one needs a reason."""
        if self in (Runtime.REFUSES, Runtime.CRASHES, Runtime.DROPS):
            return (Severity.ERROR,)
        if self is Runtime.WARNS:
            return Severity.WARNING, Severity.INFO
        return (Severity.INFO,) if self is Runtime.WORKS else (Severity.WARNING,)


class Fault:
    """A fault as `urdfctl rules`, `urdfctl explain` and all that lists faults use it.

    The function that declares it gives its name and, in its docstring, its summary and reason. A subclass says what
    else the function does: it checks files (`urdfctl.rule.Rule`), or makes the message (`FaultWithMessage`).
    """

    def __init__(  # noqa: PLR0913 (a fault has this many attributes)
        self,
        function: Callable[..., object],
        code: str,
        *,
        severity: Severity,
        runtime: str,
        authority: str,
        bad: Sequence[Written],
        good: Sequence[Written],
        distros: Iterable[str] = ALL,
        options: Iterable[str] = (),
        stage: Stage | StageDependsOn | None = None,
        because: str = "",
        explains: tuple[Fault, ...] = (),
    ) -> None:
        """Declare a fault.

        severity: of its findings, unless a finding has another one.
        runtime: what ROS, Gazebo or MoveIt does with the fault, a value of `Runtime`.
        authority: the upstream line or document that makes it true.
        bad: the smallest files with the fault, the most typical ones first, with « and » around the places of its
        findings; an example for each branch of the check and each row of a table that decides what is found.
        good: files that are like them but correct.
        options: the command-line options that the examples are linted with, but for those with options of their own.
        stage: the one that a robot or controller with an error of this fault does not pass. None: that of its family.
        because: why the severity is not one that goes with what the runtime does.
        explains: the faults whose findings about the same controller it explains, so that they are left out.
        """
        self.function = function
        self.code = code
        self.severity = severity
        self.distros = tuple(distros)
        self.stage = stage
        self.because = because
        self.explains = explains
        self._runtime = runtime
        self._authority = authority
        self._bad = bad
        self._good = good
        self._options = options

    @property
    def name(self) -> str:
        """The function's name, with hyphens."""
        return self.function.__name__.replace("_", "-")

    @property
    def module(self) -> str:
        """The module that declares it."""
        return self.function.__module__

    @property
    def url(self) -> str | None:
        """The address of its page. A fault of an installed package has none."""
        return f"{SITE}rules/{self.code}/" if self.module.startswith("urdfctl.rules.") else None

    @property
    def runtime(self) -> Runtime:
        """What the runtime does with the fault."""
        return Runtime(self._runtime)

    @property
    def summary(self) -> str:
        """The first paragraph of the docstring."""
        return self._paragraphs[0]

    @property
    def why(self) -> str:
        """The rest of the docstring."""
        return "\n\n".join(self._paragraphs[1:])

    @property
    def authority(self) -> str:
        """The upstream line or document that it is based on."""
        return _one_line(self._authority)

    @property
    def bad(self) -> list[Example]:
        """The faulty examples, the most typical one first."""
        return [example_of(written, self._options) for written in self._bad]

    @property
    def good(self) -> list[Example]:
        """The correct examples, the first one being the repaired first faulty one."""
        return [example_of(written, self._options) for written in self._good]

    @property
    def _paragraphs(self) -> list[str]:
        import inspect

        return [_one_line(part) for part in inspect.cleandoc(self.function.__doc__ or "").split("\n\n")]


if TYPE_CHECKING:

    class Declaration(TypedDict):
        """The arguments that declare a fault of any kind, beside its code."""

        severity: Severity
        runtime: str
        authority: str
        bad: Sequence[Written]
        good: Sequence[Written]
        distros: NotRequired[Iterable[str]]
        options: NotRequired[Iterable[str]]
        stage: NotRequired[Stage | StageDependsOn]
        because: NotRequired[str]
        explains: NotRequired[tuple[Fault, ...]]


class FaultWithMessage(Fault):
    """A fault that shows while something runs. What runs it gives the facts, and the fault has the message."""

    def __init__(self, message: Callable[..., str], code: str, **declared: Unpack[Declaration]) -> None:
        super().__init__(message, code, **declared)
        self.message = message

    @property
    def facts(self) -> list[str]:
        """The names of the arguments of `message`."""
        return [name for name in self.message.__annotations__ if name != "return"]


def fault(code: str, **declared: Unpack[Declaration]) -> Callable[[Callable[..., str]], FaultWithMessage]:
    """Make a function that returns a message a fault. Its name and docstring are those of the fault."""
    return lambda message: FaultWithMessage(message, code, **declared)


def example_of(written: Written, options: Iterable[str] = ()) -> Example:
    """Return an example as it is declared, with its files dedented. Tabs are kept.

    options: those of an example that has no options of its own.
    """
    from textwrap import dedent

    files = {name: dedent(text).strip("\n").rstrip() + "\n" for name, text in written.items() if name != "options"}
    return Example(files, tuple(written["options"].split() if "options" in written else options))


def _one_line(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


__all__ = [
    "Example",
    "Fault",
    "FaultWithMessage",
    "Runtime",
    "Severity",
    "Stage",
    "StageDependsOn",
    "Written",
    "example_of",
    "fault",
]
