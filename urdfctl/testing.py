"""Test helper for rules of one's own: their examples are their tests.

from acme_rules import RULES
from urdfctl.testing import assert_rule

@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_the_examples_of_a_rule_hold(rule):
    assert_rule(rule)
"""

from __future__ import annotations

import os
import tempfile

from urdfctl.diagnostic import Diagnostic
from urdfctl.fault import Example
from urdfctl.lint.engine import lint
from urdfctl.lint.examples import written
from urdfctl.lint.selection import Selection
from urdfctl.load.loader import Loader
from urdfctl.rule import Rule
from urdfctl.rules.examples import Mark, marked_lines, unmarked

__all__ = ["assert_rule"]


def assert_rule(rule: Rule) -> None:
    """Assert that a rule can be explained, finds its bad examples just where « and » mark them, and no good example.

    Raises AssertionError with the example and what the rule says about it.
    """
    assert rule.summary.endswith("."), f"{rule.code}: the docstring begins with a sentence that says what is wrong"
    assert rule.why, f"{rule.code}: the docstring has a second paragraph that says what happens then"
    assert rule.authority, f"{rule.code}: 'authority' names the line or document that makes it true"
    assert rule.bad, f"{rule.code}: 'bad' has an example"
    assert rule.good, f"{rule.code}: 'good' has an example"
    allowed = rule.runtime.severities
    assert rule.because or rule.severity in allowed, (
        f"{rule.code}: what is done with the fault is '{rule.runtime.value}', so its severity is "
        f"{' or '.join(one.value for one in allowed)}, or 'because' says why not"
    )
    for number, example in enumerate(rule.bad, 1):
        _assert_bad(rule, example, f"bad example {number} of {rule.code}")
    for number, example in enumerate(rule.good, 1):
        found = _findings(rule, example)[0]
        assert not found, f"good example {number} of {rule.code} is reported: {_said(found)}"


def _assert_bad(rule: Rule, example: Example, name: str) -> None:
    files, marks = unmarked(example.files)
    assert marks, f"{name} marks no place with « and »"
    found, folder = _findings(rule, example)
    assert found, f"{name} is not reported"
    places = {
        Mark(os.path.relpath(one.at.file, folder).replace(os.sep, "/"), one.at.start, one.at.end) for one in found
    }
    assert places == set(marks), (
        f"{name} is reported elsewhere than at its marks: {_said(found)}\n"
        f"marked:\n{marked_lines(files, marks)}\nreported:\n{marked_lines(files, places)}"
    )


def _findings(rule: Rule, example: Example) -> tuple[list[Diagnostic], str]:
    """What a rule says about an example, and the folder that it was in."""
    with tempfile.TemporaryDirectory() as made:
        folder = os.path.realpath(made)
        target, settings = written(example, folder)
        loader = Loader(settings)
        with loader.reading_for(target.path):
            loaded = loader.load(target)
            found = lint(loaded.project, list(loaded.sources.values()), Selection(), [rule]).diagnostics
    return found, folder


def _said(found: list[Diagnostic]) -> str:
    return "; ".join(f"{os.path.basename(one.at.file)}:{one.at.line}:{one.at.column}: {one.message}" for one in found)
