"""The example command for each controller uses a topic or an action that its type has."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest
import yaml
from folder import CHECKOUT
from generating import JOINTS, ROBOT, roles_of

from urdfctl.catalog.catalog import CATALOG
from urdfctl.errors import UserError
from urdfctl.generate.controllers.creation import controllers
from urdfctl.generate.controllers.recipes import recipes
from urdfctl.generate.files.next_steps import example_of
from urdfctl.generate.options import GeneratorOptions

SILENT = ("chained_filter_controller/ChainedFilter",)
"""Types that accept no command from outside."""


def _offers(part: Any) -> Iterator[tuple[str, str]]:
    """The topics and actions of the catalogue's data, each with its type."""
    if isinstance(part, list):
        for one in part:
            yield from _offers(one)
    elif isinstance(part, dict):
        name, kind = part.get("name", part.get("topic")), part.get("msg", part.get("type"))
        if isinstance(name, str) and isinstance(kind, str) and re.fullmatch(r"\w+/(msg/|action/)?\w+", kind):
            yield name.removeprefix("~/"), kind.removesuffix("Action") if "/action/" not in kind else kind
        for one in part.values():
            yield from _offers(one)


@cache
def offers(ros: int) -> set[tuple[str, str]]:
    files = (CHECKOUT / f"urdfctl/catalog/data/ros{ros}/controllers").glob("*.yaml")
    return {one for file in files for one in _offers(yaml.safe_load(file.read_text(encoding="utf-8")))}


@pytest.mark.parametrize("distro", ["noetic", "humble", "jazzy", "rolling"])
def test_each_controller_has_an_example_of_the_right_type(distro: str) -> None:
    ros = 1 if distro == "noetic" else 2
    tried = set()
    for kind in (name for name, plain in recipes()["kinds"].items() if f"ros{ros}" in plain):
        for group in (False, True):
            options = GeneratorOptions(distro, "none", (kind,), roles=roles_of(kind), group=group, namespace="r1")
            try:
                made = controllers(JOINTS, options, CATALOG, ROBOT)
            except UserError as error:
                assert f"{distro} has no" in str(error)  # noqa: PT017
                continue
            for one in (each for each in made if not each.reports and each.type.type not in SILENT):
                example = example_of(one)
                assert example, one.type.type
                words = example.split('"')[0].split()
                name, found = words[-2:]
                assert name.startswith(f"/r1/{one.name}/"), example
                leaf = name.removeprefix(f"/r1/{one.name}/").removesuffix("/goal")
                assert (leaf, found.removesuffix("ActionGoal")) in offers(ros), example
                yaml.safe_load(example.split('"')[1])
                tried.add(one.type.type)
    assert len(tried) > (8 if ros == 1 else 10)
