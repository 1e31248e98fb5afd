"""Each step of a migration makes of its examples before what its examples after say, and nothing more."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing
from difflib import unified_diff
from pathlib import Path
from typing import Any

import pytest
from sampling import sample

from urdfctl.catalog.distros import ALL
from urdfctl.config.settings import Settings
from urdfctl.fault import Example
from urdfctl.lint.examples import write_files
from urdfctl.migrate import distro
from urdfctl.migrate.engine import migrate
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.step import Step
from urdfctl.migrate.steps import STEPS
from urdfctl.migrate.trial.linting import Lint
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.rules.examples import completed

EXAMPLES = {
    f"{step.name}-{number}": (step, before, after)
    for step in STEPS
    for number, (before, after) in enumerate(step.examples, 1)
}
LATE = [
    name
    for name, (step, _, _) in EXAMPLES.items()
    if step in distro.STEPS and step.rows and all(row.since in ALL[ALL.index("humble") + 1 :] for row in step.rows)
]
"""The examples of steps between distros that humble does not need."""
MANIFEST = '<package format="3"><name>arm</name></package>\n'
OF_ROS1 = '<package format="2"><name>arm</name><buildtool_depend>catkin</buildtool_depend></package>\n'


def options_from(options: Iterable[str], step: Step) -> MigrationOptions:
    """Return what some options of the command line say, and only the part of a step."""
    names = {"--to": "target", "--from": "source", "--keep-classic": "keep_classic"}
    named: dict[str, Any] = {}
    for option in options:
        name, _, value = option.partition("=")
        named[names.get(name, name.removeprefix("--"))] = value or True
    return MigrationOptions(**named, only=frozenset([step.part]))


def migrated(step: Step, before: Example, folder: Path) -> dict[str, str]:
    """Return the files that a step alone changes, as they are then; a deleted one is empty."""
    manifest = OF_ROS1 if step.generation == 1 else MANIFEST
    package = os.path.join(folder, "arm")
    write_files(
        {"package.xml": manifest, **{name: completed(name, text) for name, text in before.files.items()}}, package
    )
    with closing(Scratch([package])) as scratch:
        settings = Settings(workspace=scratch.root)
        result = migrate(scratch, options_from(before.options, step), settings, Lint(scratch), [step])
    return {os.path.relpath(one.file, package): (one.after or b"").decode() for one in result.changes}


def differences(old: Mapping[str, str], new: Mapping[str, str]) -> Iterator[str]:
    """Yield the lines of the differences between files."""
    for name in sorted({*old, *new}):
        one, other = old.get(name, "").splitlines(), new.get(name, "").splitlines()
        yield from unified_diff(one, other, name, name, lineterm="")


@pytest.mark.parametrize("step", STEPS, ids=lambda step: step.name)
def test_a_step_has_examples(step: Step) -> None:
    assert step.examples


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_step_makes_of_an_example_what_it_says(name: str, tmp_path: Path) -> None:
    step, before, after = EXAMPLES[name]
    expected = {file: completed(file, text) if text.strip() else "" for file, text in after.items()}
    made = migrated(step, before, tmp_path)
    assert made == expected, "\n".join(["- is in 'after', + is what the step makes:", *differences(expected, made)])


@pytest.mark.parametrize("name", LATE)
def test_a_step_changes_nothing_for_a_distro_before_those_of_its_rows(name: str, tmp_path: Path) -> None:
    step, before, _ = EXAMPLES[name]
    early = migrated(step, before._replace(options=("--from=galactic", "--to=humble")), tmp_path)
    assert early == {}, "ask packages.crosses(), or say in the rows since when"


@pytest.mark.parametrize("name", sample(EXAMPLES, 5))
def test_a_step_changes_nothing_in_what_it_made(name: str, tmp_path: Path) -> None:
    step, before, after = EXAMPLES[name]
    files = {file: text for file, text in {**before.files, **after}.items() if text.strip()}
    assert migrated(step, before._replace(files=files), tmp_path) == {}
