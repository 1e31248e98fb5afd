"""In the folders of public robots, lint finds the robots, and what belongs to them, that the corpus pairs."""

from __future__ import annotations

import os
from typing import NamedTuple

from corpus import CORPUS, needs_corpus, roots

from urdfctl.discover import find
from urdfctl.lint import Selection
from urdfctl.load import Loader, Target
from urdfctl.settings import Settings


class Pairs(NamedTuple):
    """What is found: robots, robots with controllers' files, and robots with launch files; by path in the corpus."""

    robots: set[str]
    controllers: set[tuple[str, str]]
    launches: set[tuple[str, str]]


def found_in(repository: str, robots: list[str]) -> Pairs:
    """What lint finds in the folder of a repository, and beside some robots of it."""
    folder = CORPUS / repository
    loader = Loader(Settings(workspace=str(folder)), Selection(("UC000",)))
    found = find([str(folder)])
    pairs = Pairs({_inside(path) for path in found.candidates}, set(), set())
    for launch in found.launch_candidates:
        linted = loader.lint(Target(launch))
        if linted.launch and linted.path != launch:
            pairs.robots.add(_inside(linted.path))
            pairs.controllers.update((_inside(linted.path), _inside(path)) for path in linted.controllers)
            pairs.launches.update((_inside(linted.path), _inside(path)) for path in linted.files)
    for robot in robots:
        linted = loader.lint(Target(str(CORPUS / robot)))
        pairs.controllers.update((robot, _inside(path)) for path in linted.controllers)
    return pairs


def _inside(path: str) -> str:
    return os.path.relpath(path, CORPUS)


@needs_corpus
def test_the_robots_of_the_index_and_what_belongs_to_them_are_found() -> None:
    """Of the launch files in Python only facts are kept, and some pairs of the index are by names alone: the rest are
    those that no file of the corpus tells of."""
    every = [root for root in roots() if root["expands"]]
    found = Pairs(set(), set(), set())
    for repository in sorted({root["path"].partition("/")[0] for root in every}):
        paired = [r["path"] for r in every if r["controllers"] and r["path"].startswith(f"{repository}/")]
        for kind, more in zip(found, found_in(repository, paired), strict=True):
            kind.update(more)
    controllers = {(root["path"], path) for root in every for path in root["controllers"]}
    launches = {(r["path"], path) for r in every for path in r["launch"] if path.endswith((".launch", ".xml"))}
    counts = [
        len({root["path"] for root in every} & found.robots),
        len(controllers & found.controllers),
        len(launches & found.launches),
    ]
    assert all(count >= least for count, least in zip(counts, [370, 56, 115], strict=True)), counts
