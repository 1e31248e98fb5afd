"""MoveIt's planning pipelines in the form of jazzy, and its grippers in that of kilted."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from urdfctl.catalog.moves import name_moves
from urdfctl.catalog.store import moves_data
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.python_edits import PythonFile, text_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import type_names
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry, read_yaml
from urdfctl.startup.records import NamedTuple

_PLUGIN, _ADAPTERS = "planning_plugin", "request_adapters"
_DISPLAYED = "adapters validate and display the solution, as the pipeline did itself before"
_ENDS = "move_group ends where it cannot load one, so remove this file unless it can"
_PLUGINS = "moveit2 planning_pipeline.cpp: 'Exception while loading planner' is thrown on"
_PLANNERS = ("ompl_interface/OMPLPlanner", "chomp_interface/CHOMPPlanner")
"""Planners of MoveIt that have the same name in all distros; those of others are among the names that moved."""
_GRIPPER = "moveit2 moveit_simple_controller_manager: ParallelGripperCommand for parallel_gripper_action_controller"


class Adapters(NamedTuple):
    """The adapters of a pipeline in the form of jazzy, and those that have no successor."""

    requests: list[str]
    responses: list[str]
    gone: list[str]


def adapters(names: list[str]) -> Adapters:
    """Return the adapters that replace others. Those of other packages are kept as request adapters."""
    facts = moves_data()["moveit"]
    found = Adapters([], [], [])
    for name in names:
        package, _, own = name.partition("/")
        if package != facts["old"]:
            found.requests.append(name)
        elif own in facts["requests"]:
            found.requests.append(f"{facts['request']}/{facts['requests'][own]}")
        elif own in facts["responses"]:
            found.responses.append(f"{facts['response']}/{facts['responses'][own]}")
        else:
            found.gone.append(name)
    found.responses.extend(f"{facts['response']}/{name}" for name in facts["always"])
    return found._replace(responses=list(dict.fromkeys(found.responses)))


def _moveit(packages: MigratedPackages) -> Iterator[Proposal]:
    for path in packages.files(".yaml", ".yml", ".py"):
        data = packages.read(path).data
        is_moved = _PLUGIN.encode() in data or _ADAPTERS.encode() in data
        if not is_moved or not packages.crosses(moves_data()["moveit"]["since"], path):
            continue
        if path.endswith(".py"):
            yield from _in_python(PythonFile(packages.read(path)))
        elif is_yaml(path):
            yield from _in_yaml(packages, path)
    yield from _grippers(packages)


# -- YAML --------------------------------------------------------------------------------------------------------------


def _in_yaml(packages: MigratedPackages, path: str) -> Iterator[Proposal]:
    pending: list[Node] = list(read_yaml(packages.read(path)).documents)
    while pending:
        node = pending.pop()
        if isinstance(node, Mapping):
            pending += [entry.value for entry in node.entries]
            yield from _of_map(packages, node)


def _of_map(packages: MigratedPackages, pipeline: Mapping) -> Iterator[Proposal]:
    for entry in pipeline.entries:
        if entry.key.text == _PLUGIN and isinstance(entry.value, Scalar) and entry.value.text:
            replaced = _replaced_in_yaml(entry, {f"{_PLUGIN}s": [entry.value.text]}, [])
            more = tuple(_unknown(packages, entry.value))
            yield replaced._replace(entries=(*replaced.entries, *more))
        elif entry.key.text == _ADAPTERS and (names := _names(entry.value)):
            found = adapters(names)
            lists = {_ADAPTERS: found.requests}
            if pipeline.get("response_adapters") is None:
                lists["response_adapters"] = found.responses
            yield _replaced_in_yaml(entry, lists, found.gone)


def _unknown(packages: MigratedPackages, plugin: Scalar) -> Iterator[ReportEntry]:
    """Yield the entry about a planner that neither MoveIt 2 nor one of the packages has."""
    known = {name for one in name_moves() for name in (*one.names, *one.names.values())} | {*_PLANNERS}
    declared = any(plugin.text.encode() in packages.read(path).data for path in packages.files(".xml"))
    if plugin.text not in known and not declared:
        what = f"check that {packages.options.target} has the planner '{plugin.text}': {_ENDS}"
        yield ReportEntry(EntryKind.FOR_YOU, what, plugin.at, authority=_PLUGINS)


def _names(value: Node) -> list[str]:
    """The adapters in a text, or those in a list if it has old ones; empty otherwise."""
    old = moves_data()["moveit"]["old"]
    if isinstance(value, Scalar):
        return value.text.split()
    items = [item.text for item in value.items if isinstance(item, Scalar)] if isinstance(value, Sequence) else []
    return items if any(item.startswith(f"{old}/") for item in items) else []


def _replaced_in_yaml(entry: YamlEntry, lists: dict[str, list[str]], gone: list[str]) -> Proposal:
    source, value = entry.key.source, entry.value
    start = entry.key.start
    end = value.start + len(source.data[value.start : value.end].rstrip())
    indent = " " * (start - source.data.rfind(b"\n", 0, start) - 1)
    filled = {name: items for name, items in lists.items() if items}
    lines = [line for name, items in filled.items() for line in (f"{name}:", *(f"  - {item}" for item in items))]
    edit = Edit(SourceSpan(source, start, end), f"\n{indent}".join(lines))
    return Proposal((edit,), entries=_entries(entry.key.at, list(lists), gone))


def _entries(at: Place, names: list[str], gone: list[str]) -> tuple[ReportEntry, ...]:
    authority = moves_data()["moveit"]["authority"]
    entries = [ReportEntry(EntryKind.DONE, f"MoveIt reads {' and '.join(names)} as lists", at, authority=authority)]
    if "response_adapters" in names:
        entries.append(
            ReportEntry(EntryKind.DECIDED, _DISPLAYED, at, authority=authority, option="remove ValidateSolution")
        )
    for name in gone:
        message = f"adapter '{name}' is dropped: it has no successor"
        entries.append(ReportEntry(EntryKind.DONE, message, at, authority=authority))
    return tuple(entries)


# -- Python ------------------------------------------------------------------------------------------------------------


def _in_python(file: PythonFile) -> Iterator[Proposal]:
    for node in ast.walk(file.tree) if file.tree else ():
        if not isinstance(node, ast.Dict):
            continue
        keys = [text_of(key) for key in node.keys]
        for key, value in zip(node.keys, node.values, strict=True):
            text = text_of(value)
            if key is None or not text:
                continue
            if text_of(key) == _PLUGIN:
                yield _replaced_in_python(file, key, value, {f"{_PLUGIN}s": [text]}, [])
            elif text_of(key) == _ADAPTERS:
                found = adapters(text.split())
                lists = {_ADAPTERS: found.requests}
                if "response_adapters" not in keys:
                    lists["response_adapters"] = found.responses
                yield _replaced_in_python(file, key, value, lists, found.gone)


def _replaced_in_python(
    file: PythonFile, key: ast.expr, value: ast.expr, lists: dict[str, list[str]], gone: list[str]
) -> Proposal:
    """The proposal to write lists instead of a text, which may be in parentheses."""
    source = file.source
    start, end = file.span(key).start, file.span(value).end
    between = source.data[file.span(key).end : file.span(value).start]
    if b"(" in between:
        end = source.data.index(b")", end) + 1
    quote = file.text(key)[0]
    line = source.data.rfind(b"\n", 0, start) + 1
    lead = source.data[line:start].decode("utf-8", "replace")
    indent = lead[: len(lead) - len(lead.lstrip())]
    parts = []
    for name, items in lists.items():
        inner = "".join(f"\n{indent}    {quote}{item}{quote}," for item in items)
        parts.append(f"{quote}{name}{quote}: [{inner}\n{indent}]")
    edit = Edit(SourceSpan(source, start, end), f",\n{indent}".join(parts))
    return Proposal((edit,), entries=_entries(file.at(key), list(lists), gone))


# -- grippers ----------------------------------------------------------------------------------------------------------


def _grippers(packages: MigratedPackages) -> Iterator[Proposal]:
    """Change the action of those grippers whose controller is the parallel one."""
    types = type_names(packages)
    parallel = {one.controller for one in types if one.value.text.startswith("parallel_gripper_action_controller/")}
    for path in packages.files(".yaml", ".yml") if parallel else ():
        source = packages.read(path)
        if b"GripperCommand" not in source.data or not is_yaml(path):
            continue
        pending: list[Node] = list(read_yaml(source).documents)
        while pending:
            node = pending.pop()
            for entry in node.entries if isinstance(node, Mapping) else ():
                pending.append(entry.value)
                kind = entry.value.get("type") if isinstance(entry.value, Mapping) else None
                if entry.key.text in parallel and isinstance(kind, Scalar) and kind.text == "GripperCommand":
                    what = f"MoveIt commands '{entry.key.text}' by the action ParallelGripperCommand"
                    yield Proposal(
                        (Edit(SourceSpan(source, kind.start, kind.end), "ParallelGripperCommand"),),
                        entries=(ReportEntry(EntryKind.DONE, what, kind.at, authority=_GRIPPER),),
                    )


def _rows() -> Iterator[Row]:
    facts = moves_data()["moveit"]
    since, authority = facts["since"], facts["authority"]
    yield Row("planning_plugin: X", "planning_plugins: [X]", since, authority)
    yield Row("request_adapters: A B", "request_adapters: [A], response_adapters: [B]", since, authority)
    for names, package in ((facts["requests"], facts["request"]), (facts["responses"], facts["response"])):
        for old, new in names.items():
            yield Row(f"{facts['old']}/{old}", f"{package}/{new}", since, authority)
    for name in facts["dropped"]:
        yield Row(f"{facts['old']}/{name}", "", since, authority)
    yield Row("MoveIt: GripperCommand of a parallel gripper", "ParallelGripperCommand", "kilted", _GRIPPER)


MOVEIT = Step(
    "moveit",
    Part.MOVEIT,
    "MoveIt's planning pipelines and grippers",
    _moveit,
    tuple(_rows()),
    before=[
        {
            "config/ompl_planning.yaml": """
                planning_plugin: ompl_interface/OMPLPlanner
                request_adapters: >-
                  default_planner_request_adapters/AddTimeOptimalParameterization
                  default_planner_request_adapters/FixWorkspaceBounds
            """,
        },
    ],
    after=[
        {
            "config/ompl_planning.yaml": """
                planning_plugins:
                  - ompl_interface/OMPLPlanner
                request_adapters:
                  - default_planning_request_adapters/ValidateWorkspaceBounds
                response_adapters:
                  - default_planning_response_adapters/AddTimeOptimalParameterization
                  - default_planning_response_adapters/ValidateSolution
                  - default_planning_response_adapters/DisplayMotionPath
            """,
        },
    ],
)
