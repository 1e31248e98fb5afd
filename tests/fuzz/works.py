"""What urdfctl does with a robot, in this process: the work of lint, expand, why, graph, diff, view, smoke and migrate.

Work that a command does in a worker may only end with a result or exceed its budget: anything else is a fault.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from contextlib import closing
from random import Random
from typing import Any

from urdfctl.commands.generate.measuring import measure_work
from urdfctl.compare.changes import changes
from urdfctl.compare.reports import FORMATS as FORMATS_OF_DIFF
from urdfctl.compare.reports import ComparedRobot, Comparison, rendered
from urdfctl.compare.snapshot import snapshot_work
from urdfctl.compare.tree import TreeNode
from urdfctl.config.settings import Settings
from urdfctl.expand.job import expand_work
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.graph.html import html as graph_html
from urdfctl.graph.job import graph_work
from urdfctl.graph.parts import Graph
from urdfctl.graph.text_formats import dot, mermaid
from urdfctl.graph.view import collapsed, readable
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.job import WorkFunction, job_for, lint_work, perform_alone, variants_work
from urdfctl.lint.results import Report
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import result_from_json
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.migrate.engine import migrate
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.packages import Linted
from urdfctl.migrate.report import as_json, as_markdown
from urdfctl.migrate.steps import STEPS
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.report import FORMATS, render
from urdfctl.smoke.run import load_and_judge
from urdfctl.trace.job import why_work
from urdfctl.trace.text import render as render_why
from urdfctl.view.html import html as view_html
from urdfctl.view.job import portrait_details, portrait_work

ROBOT, CONTROLLERS = "urdf/arm.xacro", "config/controllers.yaml"
ADDRESSES = [
    "joint:elbow/limit/@velocity",
    "link:base",
    "joint:elbow",
    "robot",
    "ros2_control:arm/joint:elbow",
    "@x",
    "",
]
_DISTROS: list[str | None] = ["noetic", "humble", "jazzy", "rolling", "melodic", "kilted", None, None]


class Crash(Exception):
    """A part of urdfctl caught an exception of its own code, and reported it as a finding."""


def settings(random: Random) -> Settings:
    """Return the settings of a run in the current folder."""
    return Settings(distro=random.choice(_DISTROS), workspace=os.getcwd())


def done(function: WorkFunction, target: Target, random: Random, **details: Any) -> dict[str, Any]:
    """Return what work on a target gives."""
    return perform_alone(job_for(function, target, settings(random), details=details))


def lint(target: Target, random: Random) -> None:
    """Lint a target and render the findings in one format."""
    result = result_from_json(done(lint_work, target, random))
    found = merge([result.outcome], Selection())
    crashed = [one.message for one in found if one.code == "UC000"]
    if crashed or result.outcome.crashed:
        raise Crash(crashed)
    render(Report((result,), tuple(found)), random.choice(FORMATS))


def expand(target: Target, random: Random) -> None:
    done(expand_work, target, random)


def variants(target: Target, random: Random) -> None:
    done(variants_work, target, random)


def why(target: Target, random: Random) -> None:
    """Ask for a value, or for what depends on a line."""
    file = random.choice([os.path.abspath(target.path), os.path.abspath("config/sizes.yaml")])
    line = [file, random.randint(1, 30), random.choice([None, 1, 5, 40])]
    details: dict[str, Any] = random.choice([{"address": random.choice(ADDRESSES)}, {"line": line}])
    answer = done(why_work, target, random, **details)
    if "error" not in answer:
        render_why(answer)


def graph(target: Target, random: Random) -> None:
    made = Graph.from_json(done(graph_work, target, random))
    random.choice([mermaid, dot, graph_html])(random.choice([readable, collapsed])(made))


def diff(target: Target, random: Random) -> None:
    """Compare a robot with nothing, or with itself with its controllers."""
    sides = [target, random.choice([target, target._replace(controllers=(CONTROLLERS,))])]
    nodes = [done(snapshot_work, side, random, roots=[os.getcwd()])["node"] for side in sides]
    some = random.sample([*nodes, None], 2)
    old, new = (TreeNode.from_json(node) if node else TreeNode("robot", "", {}, ()) for node in some)
    comparison = Comparison("a", "b", [ComparedRobot("arm", changes(old, new), complete=True)])
    rendered(comparison, random.choice(FORMATS_OF_DIFF))


def view(target: Target, random: Random) -> None:
    details = portrait_details(settings(random), in_3d=random.random() < 0.5)
    portrait = done(portrait_work, target, random, **details)
    if portrait["scene"]:
        view_html(portrait["scene"], target.path, "")


def smoke(target: Target, random: Random) -> None:
    done(load_and_judge, target, random)


def measure(target: Target, random: Random) -> None:
    facts = done(measure_work, target, random)["facts"]
    if facts:
        RobotFacts.from_json(facts)


WORKS: Mapping[str, Callable[[Target, Random], None]] = {
    "lint": lint,
    "expand": expand,
    "why": why,
    "graph": graph,
    "diff": diff,
    "view": view,
    "smoke": smoke,
    "generate": measure,
    "variants": variants,
}


def worked(target: Target, random: Random) -> None:
    """Do something with a target: mostly lint it."""
    names = ["lint"] * 7 + [name for name in WORKS if name != "variants" or target.path.startswith("launch/")]
    WORKS[random.choice(names)](target, random)


def migrated(folder: str, random: Random) -> None:
    """Migrate a package, with a linter in this process."""
    wishes = MigrationOptions(random.choice(["humble", "jazzy", "kilted"]), random.choice([None, "noetic", "foxy"]))
    wishes = wishes._replace(simulator=random.choice([None, "gz"]), launch=random.choice(["py", "xml"]))
    with closing(Scratch([folder])) as scratch:
        targets = [Target(path) for path in scratch.files() if path.endswith((".xacro", ".launch", ".launch.py"))]

        def linted(given: Settings) -> Linted:
            loader = Loader(given)
            there = [one for one in targets if os.path.exists(one.path)]
            return [(one, lint_target(loader, one, Selection()).result) for one in there]

        result = migrate(scratch, wishes, Settings(workspace=scratch.root), linted, STEPS)
        random.choice([as_markdown, as_json])(result.lines, wishes.source, wishes.target, scratch.root)
