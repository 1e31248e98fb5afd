"""Measure a robot for the generators in a worker, with the meshes of its wheels as the smoke test reads them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from urdfctl.generate.robot.facts import Linkage, LinkFacts
from urdfctl.generate.robot.job import measured_facts
from urdfctl.generate.robot.mjcf_bodies import Surface
from urdfctl.lint.job import Work
from urdfctl.model.robot import Robot
from urdfctl.smoke.engines import TouchingLinks, testable, touching_links
from urdfctl.smoke.robot import Hinge, Mechanism, corners_of, triangles_of_collada
from urdfctl.source.disk.files import first_bytes

_MOST_BYTES = 20 << 20


def measure_work(work: Work) -> dict[str, Any]:
    """Measure a robot in a worker."""
    return measured_facts(work, corners_of, surface_of=_surface_of)


def _surface_of(path: str) -> Surface:

    try:
        return triangles_of_collada(first_bytes(path, _MOST_BYTES))
    except OSError:
        return (), ()


def measure_tree(work: Work) -> dict[str, Any]:
    """Measure a robot in a worker, with its links as a tree; none is tested for collisions yet."""

    def linked(robot: Robot, find_mesh: Callable[[str], str | None]) -> Linkage:
        return _linkage(testable(robot, find_mesh).mechanism, TouchingLinks((), ()))

    return measured_facts(work, corners_of, linked, _surface_of)


def measure_links(work: Work) -> dict[str, Any]:
    """Measure a robot in a worker, with the links that can touch. Details: the number of `samples`, and the `seed`."""
    samples, seed = int(work.details["samples"]), int(work.details["seed"])

    def linked(robot: Robot, find_mesh: Callable[[str], str | None]) -> Linkage:
        return _linkage(*touching_links(robot, find_mesh, samples, seed))

    return measured_facts(work, corners_of, linked, _surface_of)


def _linkage(mechanism: Mechanism, touching: TouchingLinks) -> Linkage:
    links = [LinkFacts(mechanism.root)]
    links += [LinkFacts(hinge.child, hinge.parent, hinge.name, _type_of(hinge)) for hinge in mechanism.hinges]
    rest = tuple(mechanism.start().items())
    spans = tuple((hinge.name, *hinge.planned) for hinge in mechanism.hinges if hinge.planned != hinge.span)
    return Linkage(tuple(links), touching.pairs, touching.hulls, rest, touching.starting, spans=spans)


def _type_of(hinge: Hinge) -> str:
    """The type of a joint for planning: one whose limits allow no motion is fixed."""
    return "fixed" if hinge.moves and hinge.type != "continuous" and hinge.span[0] == hinge.span[1] else hinge.type
