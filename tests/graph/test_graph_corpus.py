"""The edges of the graph are what lint and smoke compute, for the robots of the corpus that have controllers."""

from __future__ import annotations

from typing import Any

import pytest
from corpus import CORPUS, own_roots, roots
from graph_schema import SCHEMA
from jsonschema import Draft202012Validator
from sampling import sample

from urdfctl.config.settings import Settings
from urdfctl.control.chains import chained_claims
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.graph.build import graph_of
from urdfctl.graph.parts import Graph
from urdfctl.graph.svg import svg
from urdfctl.graph.text_formats import dot, mermaid
from urdfctl.graph.view import collapsed
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.project import Project

CONTROLLED = [root for root in roots() if root["controllers"]]
OWN = [root for root in own_roots() if root["controllers"]]


def drawn(root: dict[str, Any]) -> tuple[Graph, list[Diagnostic], Project]:
    """The graph of a robot, and lint's errors."""
    arguments = tuple((name, str(value)) for name, value in (root.get("args") or {}).items())
    files = tuple(str(CORPUS / path) for path in root["controllers"])
    linted = lint_target(
        Loader(Settings()), Target(str(CORPUS / root["path"]), arguments, controllers=files), Selection()
    )
    findings = linted.result.outcome.diagnostics
    errors = [finding for finding in findings if finding.severity is Severity.ERROR]
    return graph_of(linted.project, findings), errors, linted.project


def claims_in(graph: Graph) -> set[tuple[str, str, str]]:
    names = {node.id: node.name for node in graph.nodes}
    commands = {(names[edge.source], "command", names[edge.target]) for edge in graph.edges if edge.kind == "claims"}
    return commands | {
        (names[edge.target], "state", names[edge.source]) for edge in graph.edges if edge.kind == "reads"
    }


@pytest.mark.parametrize("root", [*OWN, *sample(CONTROLLED, 12)], ids=lambda root: root["id"])
def test_the_edges_of_the_graph_are_the_claims_of_the_controllers(root: dict[str, Any]) -> None:
    graph, _, project = drawn(root)
    session = session_of(project, graph.distro)
    claimed = {
        (each.controller.full_name.replace("\ue000", "?"), kind.value, claim.name.replace("\ue000", "?"))
        for each in session.controllers
        for kind in ClaimKind
        for claim in each.claimed(kind)
    }
    assert claims_in(graph) == claimed
    offered = {
        (kind.value, f"{offer.component}/{offer.interface}")
        for kind in ClaimKind
        for offers in session.hardware.offers(kind).values()
        for offer in offers
    }
    interfaces = {(node.kind, node.name) for node in graph.nodes if node.kind in ("command", "state")}
    assert interfaces == offered | {(kind, name) for _, kind, name in claimed}
    chained = {one.claim.name for each in session.controllers for one in chained_claims(session, each)}
    joined = {edge.source for edge in graph.edges if edge.kind == "commands" and edge.source.startswith("command:")}
    assert joined <= {f"command:{name}" for name in chained}
    Draft202012Validator(SCHEMA).validate(graph.to_json())
    for one in (graph, collapsed(graph)):
        assert all(function(one) for function in (mermaid, dot, svg))


@pytest.mark.parametrize("root", [*OWN, *sample(CONTROLLED, 12)], ids=lambda root: root["id"])
def test_the_rules_on_edges_are_the_errors_of_lint_at_their_claims(root: dict[str, Any]) -> None:
    graph, errors, project = drawn(root)
    assert {rule for edge in graph.edges for rule in edge.rules} <= {error.code for error in errors}
    on_edge = {
        (edge.source.partition(":")[2], edge.target): edge.rules for edge in graph.edges if edge.kind == "claims"
    }
    for each in session_of(project, graph.distro).controllers:
        for claim in each.claims.command:
            value = each.controller.parameters.value(claim.parameter or "")
            at = value.items[claim.element].at.span if value and claim.element is not None else None
            codes = {e.code for e in errors if at and (e.at.file, e.at.start) == (at.file, at.start)}
            codes = {
                code for code in codes if any(f"'{claim.component}'" in e.message for e in errors if e.code == code)
            }
            assert codes <= set(on_edge[each.controller.full_name, f"command:{claim.name}"])
