"""A rule: one function that looks at a project, with all that is to be known of it in decorator and docstring."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping

from urdfctl.catalog.distros import ALL
from urdfctl.diagnostic import Edit, Finding, Fix, Note, Severity
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple

Check = Callable[[Project], Iterator[Finding]]
Example = Mapping[str, str]


class Rule(NamedTuple):
    """A rule as the engine, `urdfctl rules` and `urdfctl explain` see it.

    In the texts of `bad_as_written` the place of the expected finding stands between « and ». `options` are those of
    the command line that the examples are linted with. A rule with `whole_robot` is silent where a part of the robot
    could not be expanded; one that is not `in_library` where conditions are not decided, and alternatives stand side by
    side.
    """

    code: str
    check: Check
    severity: Severity
    authority_as_written: str
    bad_as_written: Example
    good_as_written: Example
    distros: tuple[str, ...] = ALL
    whole_robot: bool = False
    in_library: bool = True
    options: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """What the fault is called: the function's name, with hyphens."""
        return self.check.__name__.replace("_", "-")

    @property
    def of_smoke(self) -> bool:
        """Whether it is the smoke test that tells it, and not reading."""
        return self.code.startswith("UC9")

    @property
    def summary(self) -> str:
        """The docstring's first paragraph."""
        return self._paragraphs[0]

    @property
    def why(self) -> str:
        """The rest of the docstring."""
        return "\n\n".join(self._paragraphs[1:])

    @property
    def authority(self) -> str:
        """The upstream line or document that makes the rule true."""
        return _one_line(self.authority_as_written)

    @property
    def bad(self) -> dict[str, str]:
        """The files of the faulty example, by name."""
        return {name: _file(content) for name, content in self.bad_as_written.items()}

    @property
    def good(self) -> dict[str, str]:
        """The files of the sound example, by name."""
        return {name: _file(content) for name, content in self.good_as_written.items()}

    @property
    def _paragraphs(self) -> list[str]:
        return [_one_line(part) for part in cleandoc(self.check.__doc__ or "").split("\n\n")]


def rule(  # noqa: PLR0913 (each is a thing to be known of a rule)
    code: str,
    *,
    severity: Severity,
    authority: str,
    bad: Example,
    good: Example,
    distros: Iterable[str] = ALL,
    whole_robot: bool = False,
    in_library: bool = True,
    options: Iterable[str] = (),
) -> Callable[[Check], Rule]:
    """Make a rule of a function: its name is the function's, its summary and reason are the docstring's."""

    def made(check: Check) -> Rule:
        return Rule(
            code, check, severity, authority, bad, good, tuple(distros), whole_robot, in_library, tuple(options)
        )

    return made


def _one_line(text: str) -> str:
    return re.sub(r"\s+", " ", text).strip()


def _file(content: str) -> str:
    """An example's file: tabs in it are kept."""
    from textwrap import dedent

    return dedent(content).strip("\n").rstrip() + "\n"


def cleandoc(text: str) -> str:
    """inspect.cleandoc, imported when somebody reads: lint never does."""
    import inspect

    return inspect.cleandoc(text)


__all__ = ["Edit", "Finding", "Fix", "Note", "Project", "Rule", "Severity", "rule"]
