"""What is compared of a target: its description, its controllers, MoveIt's limits, and what is started."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from typing import Any

from urdfctl.compare.tree import TreeNode, merged, node_of, plain
from urdfctl.config.settings import Settings
from urdfctl.control.parameters.given import given_values
from urdfctl.errors import UserError
from urdfctl.lint.job import Work, run_on_targets
from urdfctl.load.loader import LoadedTarget
from urdfctl.load.target import Target
from urdfctl.model.controllers import Controller, Controllers
from urdfctl.model.project import Project
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple


class Snapshot(NamedTuple):
    """A robot as it is compared.

    complete: whether every part of it could be expanded.
    """

    node: TreeNode
    complete: bool


def snapshots(targets: list[Target], settings: Settings, roots: Sequence[str]) -> list[Snapshot]:
    """Return what is compared of some targets.

    roots: the folders whose paths are left out of texts, the innermost first.
    Raises UserError if one of them cannot be expanded, RuntimeError if urdfctl crashed.
    """
    found = []
    results = run_on_targets(snapshot_work, targets, settings, details=[{"roots": list(roots)}] * len(targets))
    for target, result in zip(targets, results, strict=True):
        if not isinstance(result, dict):
            if result.our_fault:
                raise RuntimeError(result.reason)
            raise UserError(f"'{target.path}' cannot be compared: {result.reason}")
        if result["node"] is None:
            path = without(target.path, roots[-1:])
            raise UserError(f"'{path}' cannot be expanded; to see why, run: urdfctl lint {path}")
        found.append(Snapshot(TreeNode.from_json(result["node"]), result["complete"]))
    return found


def snapshot_work(work: Work) -> dict[str, Any]:
    """Take a snapshot in a worker."""
    loaded = work.loader.load(work.target)
    node = snapshot_of(loaded, work.details["roots"])
    return {"node": node.to_json() if node is not None else None, "complete": loaded.project.complete}


def snapshot_of(loaded: LoadedTarget, roots: Sequence[str]) -> TreeNode | None:
    """Return the tree of a loaded target; None without a description."""
    if loaded.root is None:
        return None

    def shown(text: str) -> str:
        return without(text, roots).replace(UNKNOWN, "?")

    robot = node_of(loaded.root, shown)
    project = loaded.project
    children = (*robot.children, *_controllers(project.controllers), *_limits(project), *_started(project))
    return robot._replace(key="", children=merged(list(children)))


def without(text: str, roots: Sequence[str]) -> str:
    """Return a text without the paths of some folders."""
    for root in roots:
        text = text.replace(root.rstrip(os.sep) + os.sep, "")
    return text


def _controllers(controllers: Controllers | None) -> Iterator[TreeNode]:
    for kind, nodes in (
        ("manager", controllers.managers if controllers else ()),
        ("controller", controllers.controllers if controllers else ()),
        ("node", controllers.nodes if controllers else ()),
    ):
        for each in nodes:
            values = {name: _text(value) for name, value in given_values(each.parameters).items()}
            if isinstance(each, Controller) and each.type is not None:
                values["type"] = each.type.text
            yield TreeNode(kind, "/".join(filter(None, (each.namespace, each.name))), values, ())


def _text(value: object) -> str:
    return plain(value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)).replace(UNKNOWN, "?")


def _limits(project: Project) -> Iterator[TreeNode]:
    for limits in project.moveit.limits if project.moveit else ():
        values = {key.text: plain(value.text) for key, value in limits.values}
        yield TreeNode("moveit_limits", limits.joint.text, values, ())
    semantic = project.moveit.semantic if project.moveit else None
    for group in semantic.groups if semantic else ():
        parts = {"links": group.links, "joints": group.joints, "groups": group.groups}
        values = {name: " ".join(sorted(key.text for key in keys)) for name, keys in parts.items() if keys}
        chains = (f"{one.base.text if one.base else '?'} to {one.tip.text if one.tip else '?'}" for one in group.chains)
        yield TreeNode("group", group.name.text, {**values, "chains": ", ".join(sorted(chains))}, ())


def _started(project: Project) -> Iterator[TreeNode]:
    for name in project.started or ():
        yield TreeNode("started", name.replace(UNKNOWN, "?"), {}, ())
    for node in project.launch.nodes if project.launch else ():
        if node.sure and UNKNOWN not in node.package.text + node.executable.text:
            name = f"{node.namespace or ''}/{node.name or ''}".replace(UNKNOWN, "?").strip("/")
            yield TreeNode("node_started", f"{node.package.text}/{node.executable.text} {name}".strip(), {}, ())
    for simulation in project.launch.simulations if project.launch else ():
        if simulation.sure:
            yield TreeNode("simulator_started", simulation.simulator, {}, ())
