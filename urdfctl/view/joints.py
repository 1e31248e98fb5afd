"""What the page says of each joint: how it is controlled, its limits, what commands it, and what lint finds in it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.graph.parts import Graph, GraphNode
from urdfctl.model.robot import Joint, Link, Robot
from urdfctl.report.common import relative
from urdfctl.smoke.robot import Hinge

COMMANDED = ("position", "velocity", "effort")
CONTROLS = {
    **{kind: f"by {kind}" for kind in COMMANDED},
    "state": "state only",
    "mimic": "mimics another joint",
    "none": "not controlled",
}
"""How a joint is controlled, and in words."""


class Wiring:
    """What a graph says of each joint."""

    def __init__(self, graph: Graph | None) -> None:
        self._nodes = {node.id: node for node in graph.nodes} if graph else {}
        self._edges = graph.edges if graph else ()

    def interfaces(self, joint: str, kind: str) -> list[GraphNode]:
        """Return the interfaces of a joint; kind: command or state."""
        return [
            node
            for node in self._nodes.values()
            if node.kind == kind and node.detail and node.name == f"{joint}/{node.detail}"
        ]

    def beside(self, interfaces: Sequence[GraphNode], kinds: Sequence[str]) -> list[GraphNode]:
        """Return what is wired to some interfaces by edges of some kinds."""
        ids = {node.id for node in interfaces}
        found = [
            edge.target if edge.source in ids else edge.source
            for edge in self._edges
            if edge.kind in kinds and ids & {edge.source, edge.target}
        ]
        return [self._nodes[key] for key in dict.fromkeys(found)]

    def codes(self, joint: str) -> set[str]:
        """Return the codes of lint's errors about a joint and the edges at its interfaces."""
        nodes = [*self.interfaces(joint, "command"), *self.interfaces(joint, "state")]
        ids = {node.id for node in nodes} | {f"joint:{joint}"}
        found = {code for key in ids if key in self._nodes for code in self._nodes[key].rules}
        return found | {code for edge in self._edges if ids & {edge.source, edge.target} for code in edge.rules}

    def control(self, hinge: Hinge) -> str:
        """Return how a joint is controlled: one of CONTROLS."""
        commands = self.interfaces(hinge.name, "command")
        claimed = [node for node in commands if self.beside([node], ("claims",))]
        has_controllers = any(node.kind == "controller" for node in self._nodes.values())
        for node in claimed or ([] if has_controllers else commands):
            for kind in COMMANDED:
                if kind in node.detail.lower():
                    return kind
        if hinge.mimic is not None:
            return "mimic"
        return "state" if self.interfaces(hinge.name, "state") else "none"


def described(hinge: Hinge, robot: Robot, wiring: Wiring, findings: Sequence[Diagnostic]) -> dict[str, Any]:
    """Return what the page says of a joint, as plain data."""
    of_joint = findings_about(robot.joint(hinge.name), findings, wiring.codes(hinge.name))
    of_link = findings_in_link(robot.link(hinge.child), findings)
    own = list({id(finding): finding for finding in (*of_joint, *of_link)}.values())
    return {
        "control": wiring.control(hinge),
        "error": any(finding.severity is Severity.ERROR for finding in own),
        "facts": [list(fact) for fact in _facts(hinge, wiring)],
        "findings": [
            {
                "code": finding.code,
                "severity": finding.severity.value,
                "message": finding.message,
                "at": f"{finding.at.file}:{finding.at.line}:{finding.at.column}",
            }
            for finding in map(relative, own)
        ],
    }


def findings_about(joint: Joint | None, findings: Sequence[Diagnostic], codes: set[str]) -> Iterator[Diagnostic]:
    """Yield the findings that name a joint, or are in its element and name no other part.

    codes: of the errors that the graph shows at the joint.
    """
    if joint is None:
        return
    file, start, end = joint.at.span.file, joint.at.span.start, joint.at.closing or joint.at.span.end
    for finding in findings:
        is_within = finding.at.file == file and start <= finding.at.start <= end
        is_named = f"'{joint.name}'" in finding.message
        names_none = "'" not in finding.message
        if (is_named and (is_within or finding.code in codes or "joint" in finding.message)) or (
            is_within and (names_none or not finding.in_macro)
        ):
            yield finding


def findings_in_link(link: Link | None, findings: Sequence[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield the findings in the element of a link, and those that call it a link by its name."""
    if link is None:
        return
    file, start, end = link.at.span.file, link.at.span.start, link.at.closing or link.at.span.end
    for finding in findings:
        is_named = f"link '{link.name}'" in finding.message
        is_within = finding.at.file == file and start <= finding.at.start <= end
        if is_named or (is_within and not finding.in_macro):
            yield finding


def _facts(hinge: Hinge, wiring: Wiring) -> Iterator[tuple[str, str]]:
    yield "type", hinge.type
    yield "moves", f"{hinge.child} in {hinge.parent}"
    if hinge.moves:
        yield "limits", _limits(hinge)
    if hinge.mimic is not None:
        leader, factor, offset = hinge.mimic
        yield "mimics", f"{factor:g} times {leader}" + (f" + {offset:g}" if offset else "")
    for label, kind, ways in (
        ("command interfaces", "command", (("hardware", ("drives",)), ("commanded by", ("claims",)))),
        ("state interfaces", "state", (("read by", ("reads",)),)),
    ):
        nodes = wiring.interfaces(hinge.name, kind)
        if nodes:
            yield label, ", ".join(node.detail for node in nodes)
        for name, kinds in ways:
            others = wiring.beside(nodes, kinds)
            if others:
                yield name, ", ".join(_named(node) for node in others)


def _named(node: GraphNode) -> str:
    name = node.name.removeprefix("/")
    return f"{name} ({node.detail})" if node.detail else name


def _limits(hinge: Hinge) -> str:
    parts = []
    if hinge.type != "continuous" and hinge.lower is not None and hinge.upper is not None:
        parts.append(f"{hinge.lower:g} to {hinge.upper:g} {hinge.unit}")
    if hinge.velocity is not None:
        parts.append(f"{hinge.velocity:g} {hinge.unit}/s")
    if hinge.effort is not None:
        parts.append(f"{hinge.effort:g} {hinge.effort_unit}")
    return ", ".join(parts) or "none"
