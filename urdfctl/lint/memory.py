"""What the rules found in the last project, for the next one: several launch files start one robot.

A rule is a function of the project. What it found holds for another project too, if all that it read of the project is
the same there. So the project notes what each rule reads.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from urdfctl.diagnostic import Finding
from urdfctl.model.project import Project
from urdfctl.rule import Rule
from urdfctl.source.same import is_same
from urdfctl.startup.per_object import Noting
from urdfctl.startup.records import NamedTuple


class _Found(NamedTuple):
    """What a rule found, and the fields of the project that it read."""

    fields: dict[str, object]
    findings: tuple[Finding, ...]


class RuleMemory:
    """The findings of each rule in the last project that it ran on."""

    def __init__(self) -> None:
        self._found: dict[str, _Found] = {}

    def finder(self, project: Project) -> Callable[[Rule], tuple[Finding, ...]]:
        """Return a function that returns what a rule finds in a project."""
        noting: Any = _NotingProject(project)

        def find(rule: Rule) -> tuple[Finding, ...]:
            last = self._found.pop(rule.code, None)
            if last is None or not all(is_same(value, getattr(project, name)) for name, value in last.fields.items()):
                noting.noted = set()
                findings = tuple(rule.check(noting))
                last = _Found({name: getattr(project, name) for name in noting.noted}, findings)
            self._found[rule.code] = last
            return last.findings

        return find


class _NotingProject(Noting):
    """Has the attributes of a project."""

    def __init__(self, project: Project) -> None:
        self._project = project
        self.noted: set[str] = set()

    def _replace(self, **changes: Any) -> Project:
        self.noted.update(Project._fields)
        return self._project._replace(**changes)


def _field(name: str) -> property:
    def value(project: _NotingProject) -> object:
        project.noted.add(name)
        return getattr(project._project, name)

    return property(value)


def _attributes() -> Iterator[tuple[str, Callable[..., Any] | property]]:
    """The fields of a project, noted; and its properties and methods, which read those."""
    for name, attribute in vars(Project).items():
        if name in Project._fields:
            yield name, _field(name)
        elif not name.startswith("_"):
            yield name, attribute


for _name, _attribute in _attributes():
    setattr(_NotingProject, _name, _attribute)
