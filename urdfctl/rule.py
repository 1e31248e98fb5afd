"""A rule: one function that checks a project. Its decorator and docstring hold everything else about it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from enum import Enum

from urdfctl.catalog.distros import ALL
from urdfctl.diagnostic import Edit, Finding, Fix, Note, Severity
from urdfctl.model.project import Project
from urdfctl.model.stage import Stage, StageDependsOn
from urdfctl.startup.records import NamedTuple

Check = Callable[[Project], Iterator[Finding]]
Example = Mapping[str, str]


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


class Rule(NamedTuple):
    """A rule as the engine, `urdfctl rules` and `urdfctl explain` use it.

    In the texts of `bad_as_written`, « and » mark the place of the expected finding. `options` are the command-line
    options that the examples are linted with. A rule with `whole_robot` does not run if a part of the robot could not
    be expanded. A rule without `in_library` does not run on a macro library, where both branches of a condition are
    kept.
    """

    code: str
    check: Check
    severity: Severity
    runtime_as_written: str
    """What the runtime does with the fault, a value of `Runtime`."""
    authority_as_written: str
    bad_as_written: Example
    good_as_written: Example
    distros: tuple[str, ...] = ALL
    whole_robot: bool = False
    in_library: bool = True
    options: tuple[str, ...] = ()
    stage: Stage | StageDependsOn | None = None
    """The stage that a robot or controller with an error of this rule does not pass. None: that of its family."""
    message: str = ""
    """The message of a smoke rule, with named fields for `str.format`. Empty for a rule of lint."""
    because: str = ""
    """Why the severity is not one that goes with what the runtime does."""
    explains: tuple[Rule, ...] = ()
    """The smoke rules whose findings about the same controller this one explains, so that they are left out."""

    @property
    def name(self) -> str:
        """The name of the fault: the function's name, with hyphens."""
        return self.check.__name__.replace("_", "-")

    @property
    def runtime(self) -> Runtime:
        """What the runtime does with the fault."""
        return Runtime(self.runtime_as_written)

    @property
    def of_smoke(self) -> bool:
        """Whether the smoke test reports it, not lint."""
        return self.code.startswith("UC9")

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
        """The upstream line or document that the rule is based on."""
        return _one_line(self.authority_as_written)

    @property
    def bad(self) -> dict[str, str]:
        """The files of the faulty example, by name."""
        return {name: _file(content) for name, content in self.bad_as_written.items()}

    @property
    def good(self) -> dict[str, str]:
        """The files of the correct example, by name."""
        return {name: _file(content) for name, content in self.good_as_written.items()}

    @property
    def _paragraphs(self) -> list[str]:
        return [_one_line(part) for part in cleandoc(self.check.__doc__ or "").split("\n\n")]


def rule(  # noqa: PLR0913 (a rule has this many attributes)
    code: str,
    *,
    severity: Severity,
    runtime: str,
    authority: str,
    bad: Example,
    good: Example,
    distros: Iterable[str] = ALL,
    whole_robot: bool = False,
    in_library: bool = True,
    options: Iterable[str] = (),
    stage: Stage | StageDependsOn | None = None,
    message: str = "",
    because: str = "",
    explains: tuple[Rule, ...] = (),
) -> Callable[[Check], Rule]:
    """Make a function a rule. Its name is the function's name; its summary and reason come from the docstring.

    runtime: what ROS, Gazebo or MoveIt does with the fault, a value of `Runtime`. because: why the severity is not one
    that goes with it; the severity of a smoke rule follows from what it measures.
    """

    def made(check: Check) -> Rule:
        return Rule(
            code=code,
            check=check,
            severity=severity,
            runtime_as_written=runtime,
            authority_as_written=authority,
            bad_as_written=bad,
            good_as_written=good,
            distros=tuple(distros),
            whole_robot=whole_robot,
            in_library=in_library,
            options=tuple(options),
            stage=stage,
            message=message,
            because=because,
            explains=explains,
        )

    return made


def _one_line(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


def _file(content: str) -> str:
    """The text of an example's file, dedented. Tabs are kept."""
    from textwrap import dedent

    return dedent(content).strip("\n").rstrip() + "\n"


def cleandoc(text: str) -> str:
    """Return inspect.cleandoc(text). The import happens on the first call, because lint never needs it."""
    import inspect

    return inspect.cleandoc(text)


__all__ = [
    "Edit",
    "Finding",
    "Fix",
    "Note",
    "Project",
    "Rule",
    "Runtime",
    "Severity",
    "Stage",
    "StageDependsOn",
    "rule",
]
