"""Rules of other packages, which the user installed beside urdfctl with an entry point in the group `urdfctl.rules`."""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

from urdfctl.errors import UserError
from urdfctl.rule import Rule
from urdfctl.startup.installed_packages import entry_points_of
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = "urdfctl.rules"
"""The group of entry points. Each names a sequence of rules: `acme = "acme_rules:RULES"`."""
_CODE = r"(?!UC)[A-Z]{2,}[0-9]{3,}"


class InstalledRules(NamedTuple):
    """The rules of one entry point."""

    origin: str
    """The distribution that brings them, with its version."""
    rules: tuple[Rule, ...]
    module: str


@cache
def installed_rules() -> tuple[InstalledRules, ...]:
    """Import and return the rules of other packages. UserError if some cannot be used; then it says which and why."""
    found = [_loaded(origin, entry) for origin, entry in entry_points_of(GROUP)]
    origins: dict[str, str] = {}
    for installed in found:
        for rule in installed.rules:
            if rule.code in origins:
                raise UserError(f"rule {rule.code} comes from both {origins[rule.code]} and {installed.origin}")
            origins[rule.code] = installed.origin
    return tuple(found)


def _loaded(origin: str, entry: EntryPoint) -> InstalledRules:
    try:
        rules = tuple(entry.load())
    except Exception as error:  # noqa: BLE001 (somebody else's code may raise anything)
        why = f"{type(error).__name__}: {error}"
        raise UserError(f"the rules of {origin} ({entry.value}) cannot be loaded: {why}") from None
    for rule in rules:
        if not isinstance(rule, Rule):
            raise UserError(f"{entry.value} of {origin} has {rule!r}, which is not a rule; see docs/own-rules.md")
        if not re.fullmatch(_CODE, rule.code):
            raise UserError(
                f"rule '{rule.code}' of {origin} needs a code of its own, such as ACME001; those with UC are urdfctl's"
            )
    return InstalledRules(origin, rules, entry.module)
