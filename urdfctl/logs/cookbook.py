"""Writes docs/cookbook.md, the commonest failures: `python -m urdfctl.logs.cookbook > docs/cookbook.md`."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Mapping
from difflib import unified_diff

from urdfctl.catalog.distros import in_words
from urdfctl.catalog.log_messages import Cause, LogMessage, log_messages
from urdfctl.rule import Rule
from urdfctl.rules import all_rules

COMMONEST = {
    "no-hardware-interface-in-joint": "UC201",
    "resource-not-found-in-interface": "UC461",
    "controller-type-does-not-exist": "",
    "controller-type-not-specified": "UC524",
    "gazebo-pid-gains-absent": "",
    "spawner-waits-for-manager": "UC508",
    "hardware-class-does-not-exist": "UC353",
    "type-param-not-defined": "UC420",
    "command-interface-not-available": "UC450",
    "system-plugin-not-loaded": "UC505",
}
"""The messages that most people ask about in public, those of ROS 1 first, by their ids in the catalogue; each with the
rule whose example shows the way out, where one does."""

_HEAD = """\
# Cookbook: the ten commonest failures

The message that you see, why it is printed, and the way out. `urdfctl lint` finds the causes that bear a code, at the
line you wrote; `urdfctl explain "the message"` tells this and 300 more in the terminal, and takes whole logs. What
stands in capitals is a name of yours.
This page is made by `python -m urdfctl.logs.cookbook > docs/cookbook.md`.
"""


def cookbook() -> str:
    """The page: a section for each message."""
    messages = {message.id: message for message in log_messages()}
    rules = {rule.code: rule for rule in all_rules()}
    return "\n".join([_HEAD, *("\n".join(_section(messages[name], rules, code)) for name, code in COMMONEST.items())])


def _section(message: LogMessage, rules: Mapping[str, Rule], shown: str) -> Iterator[str]:
    first, *others = (f"`{_named(pattern)}`" for pattern in message.patterns[:2])
    yield f"## {first}\n"
    printed = f"Printed by {message.by} ({in_words(message.distros)})"
    yield f"{printed}{''.join(f', also as {other}' for other in others)}. {_prose(message.meaning)}\n"
    yield "Causes, the likeliest first:\n"
    yield from (f"{number}. {_cause(cause, rules)}" for number, cause in enumerate(message.causes, 1))
    yield f"\n**The way out:** {_prose(message.fix)}\n"
    if shown:
        yield from _example(rules[shown])


def _cause(cause: Cause, rules: Mapping[str, Rule]) -> str:
    """A cause, with links to the rules that find it."""
    links = ", ".join(f"[{code} {rules[code].name}]({_file(rules[code])})" for code in cause.rules)
    return f"{_prose(cause.text)} ({links})" if links else _prose(cause.text)


def _file(rule: Rule) -> str:
    return f"../{rule.check.__module__.replace('.', '/')}.py"


def _example(rule: Rule) -> Iterator[str]:
    """How the wrong example of a rule becomes the right one."""
    yield f"{rule.code} {rule.name}, mended:\n```diff"
    for name, good in rule.good.items():
        bad = re.sub("[«»]", "", rule.bad.get(name, ""))
        changes = unified_diff(bad.splitlines(), good.splitlines(), name, name, n=3, lineterm="")
        yield from (line for line in changes if not line.startswith(("+++", "@@")))
    yield "```\n"


def _named(text: str) -> str:
    """A text of the catalogue, with the names of its values in capitals."""
    return re.sub(r"\{\{|\}\}|\{(\w+)(:\w+)?\}", lambda found: found[1].upper() if found[1] else found[0][0], text)


def _prose(text: str) -> str:
    """The same, whose angle brackets Markdown does not take for HTML."""
    return _named(text).replace("<", "&lt;")


if __name__ == "__main__":
    sys.stdout.write(cookbook())
