"""In the folders of public robots, lint finds the robots, and what belongs to them, that the corpus pairs."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from corpus import CORPUS, needs_corpus, roots
from sampling import WHOLE, sample

from urdfctl.config.settings import Settings
from urdfctl.discover.robots import discover_files
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target


class Pairs(NamedTuple):
    """What is found: robots, robots with controller files, and robots with launch files; by path in the corpus."""

    robots: set[str]
    controllers: set[tuple[str, str]]
    launches: set[tuple[str, str]]


def found_in(repository: str, robots: list[str]) -> Pairs:
    """What lint finds in the folder of a repository, and beside some robots of it."""
    folder = CORPUS / repository
    loader = Loader(Settings(workspace=str(folder)))
    found = discover_files([str(folder)])
    pairs = Pairs({_inside(path) for path in found.candidates}, set(), set())
    for launch in found.launch_candidates:
        linted = lint_target(loader, Target(launch), Selection(("UC000",))).result
        if linted.launch and linted.path != launch:
            pairs.robots.add(_inside(linted.path))
            pairs.controllers.update((_inside(linted.path), _inside(path)) for path in linted.controllers)
            pairs.launches.update((_inside(linted.path), _inside(path)) for path in linted.files)
    for robot in robots:
        linted = lint_target(loader, Target(str(CORPUS / robot)), Selection(("UC000",))).result
        pairs.controllers.update((robot, _inside(path)) for path in linted.controllers)
    return pairs


def repository(root: dict[str, Any]) -> str:
    return str(root["path"]).partition("/")[0]


def _inside(path: str) -> str:
    return os.path.relpath(path, CORPUS)


@needs_corpus
def test_the_robots_of_the_index_and_what_belongs_to_them_are_found() -> None:
    """Of the launch files in Python only facts are kept, and some pairs of the index are by names alone: the rest are
    those that no file of the corpus tells of."""
    repositories = sample(sorted({repository(root) for root in roots() if root["expands"]}), 6)
    every = [root for root in roots() if root["expands"] and repository(root) in repositories]
    found = Pairs(set(), set(), set())
    for name in repositories:
        paired = [root["path"] for root in every if root["controllers"] and repository(root) == name]
        for kind, more in zip(found, found_in(name, paired), strict=True):
            kind.update(more)
    controllers = {(root["path"], path) for root in every for path in root["controllers"]}
    launches = {(r["path"], path) for r in every for path in r["launch"] if path.endswith((".launch", ".xml"))}
    counts = [
        len({root["path"] for root in every} & found.robots),
        len(controllers & found.controllers),
        len(launches & found.launches),
    ]
    least = [370, 56, 115] if WHOLE else [88, 21, 11]
    assert all(count >= fewest for count, fewest in zip(counts, least, strict=True)), counts
