"""Names of hardware and simulator plugins that were renamed: the fixes that the rules on migration suggest."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.migrate.packages import Packages
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Step
from urdfctl.migrate.wishes import Part
from urdfctl.rule import Rule
from urdfctl.rules import rule_of

_CODES = ("UC702", "UC703")


def _old_names(packages: Packages) -> Iterator[Proposal]:
    for loaded in packages.loaded(packages.wishes.target):
        for code in _CODES:
            rule = rule_of(code)
            for finding in rule.check(loaded.project):
                fix = finding.fix
                if fix and fix.edits:
                    message = f"{finding.message}"
                    entry = Entry(EntryKind.DONE, message, finding.at, authority=_authority(rule))
                    yield Proposal(edits=fix.edits, entries=(entry,), fixes=(code,))


def _authority(rule: Rule) -> str:
    return rule.authority.partition(";")[0]


OLD_NAMES = Step(
    name="old-names",
    part=Part.URDF,
    summary="Plugins that were renamed",
    propose=_old_names,
)
