"""What is shown when the user points at something: a name, a parameter, or an expression with its values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.map_parameters import matching
from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import Configured, session_of
from urdfctl.diagnostic import Diagnostic
from urdfctl.load.loader import LoadedTarget
from urdfctl.model.project import Project
from urdfctl.model.robot import Joint
from urdfctl.server.analysis.names import JOINT, LINK, NamePlace
from urdfctl.server.analysis.question import Question
from urdfctl.server.features.about_faults import faults_at
from urdfctl.server.features.about_names import described_name
from urdfctl.server.features.about_parameters import described_parameter
from urdfctl.server.features.fitting import INTERFACES, elements_at
from urdfctl.server.features.navigation import NamesAround
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.xml.dom import Element
from urdfctl.trace.uses import uses_of

_MOST_VALUES = 6
_MOST_USES = 12


def hover(question: Question, findings: Sequence[Diagnostic] = ()) -> str | None:
    """Return what is known about a place, as Markdown; None if that is nothing. findings: those of the file."""
    parts = [*_parameter(question), *_name(question), *_claims(question), *_values(question)]
    parts += faults_at(question, findings)
    return "\n\n".join(dict.fromkeys(parts)) or None


# -- names -----------------------------------------------------------------------------------------------------------


def _name(question: Question) -> Iterator[str]:
    around = NamesAround(question._replace(robots=question.shown))
    if around.at is None:
        return
    for name in {(one.kind, one.text): one for one in around.all if one.span == around.at.span}.values():
        yield "  \n".join([f"**{name.kind}** `{name.text}`{_scope(name)}", *described_name(question, name)])
        yield from _of_robots(question.robots, name)


def _scope(name: NamePlace) -> str:
    return f" of macro `{name.scope}`" if name.scope else ""


def _element(robot: LoadedTarget, name: NamePlace) -> Element | None:
    if robot.root is None or name.kind not in {JOINT, LINK}:
        return None
    children = robot.root.elements()
    return next((one for one in children if one.tagName == name.kind and one.attrs.get("name") == name.text), None)


def _of_robots(robots: Sequence[LoadedTarget], name: NamePlace) -> Iterator[str]:
    """What is known of a joint or link in all robots that have it, which may be in several namespaces."""
    uses: dict[str, None] = {}
    for loaded in robots:
        element, robot = _element(loaded, name), loaded.project.robot
        if element is None or robot is None:
            continue
        joint = robot.joint(name.text) if name.kind == JOINT else None
        if joint is not None:
            yield _joint(joint)
        uses.update({f"- {use.kind} `{use.name}`: {use.how}": None for use in uses_of(loaded.project, element)})
    lines = list(uses)[:_MOST_USES]
    if len(uses) > _MOST_USES:
        lines.append(f"- and {len(uses) - _MOST_USES} more")
    if lines:
        yield "\n".join(["used by:", *lines])


def _joint(joint: Joint) -> str:
    unit = "m" if joint.type == "prismatic" else "rad"
    effort = "N" if joint.type == "prismatic" else "N m"
    words = [joint.type or "no type"]
    limit = joint.limit
    if limit is not None and limit.lower is not None and limit.upper is not None and joint.type != "continuous":
        words.append(f"{limit.lower.text} to {limit.upper.text} {unit}")
    if limit is not None and limit.velocity is not None:
        words.append(f"at most {limit.velocity.text} {unit}/s")
    if limit is not None and limit.effort is not None:
        words.append(f"at most {limit.effort.text} {effort}")
    if joint.mimic is not None and joint.mimic.joint:
        words.append(f"follows `{joint.mimic.joint}`")
    if joint.parent is not None and joint.parent.name and joint.child is not None and joint.child.name:
        words.append(f"connects `{joint.parent.name}` to `{joint.child.name}`")
    return ", ".join(words)


# -- interfaces ------------------------------------------------------------------------------------------------------


def _claims(question: Question) -> Iterator[str]:
    """Who uses the interface of `<command_interface name>` or `<state_interface name>` at the place."""
    users: dict[str, dict[str, None]] = {}
    for here in elements_at(question._replace(robots=question.shown)):
        kind, name = INTERFACES.get(here.element.tagName), here.element.attrs.get("name", "")
        if kind is None or here.parent is None or not question.is_in(here.element.at["name"].span):
            continue
        component = here.parent.attrs.get("name", "")
        found = users.setdefault(f"**{kind.value} interface** `{component}/{name}`", {})
        for robot in question.robots:
            found.update(dict.fromkeys(_users(robot.project, kind, component, name)))
    for heading, lines in users.items():
        yield "\n".join([heading, *(lines or ["no controller uses it"])])


def _users(project: Project, kind: ClaimKind, component: str, name: str) -> Iterator[str]:
    if project.controllers is None or not project.distros:
        return
    verb = "claims it" if kind is ClaimKind.COMMAND else "reads it"
    for each in session_of(project, project.distro or project.distros[-1]).controllers:
        if any((claim.component, claim.interface) == (component, name) for claim in each.claimed(kind)):
            yield f"- controller `{each.controller.in_namespace}` {verb}"


# -- parameters of controllers ---------------------------------------------------------------------------------------


def _parameter(question: Question) -> Iterator[str]:
    for loaded in question.robots:
        project = loaded.project
        if project.controllers is None or not project.distros:
            continue
        distro = project.distro or project.distros[-1]
        for each in session_of(project, distro).controllers:
            yield from _type(question, each, distro)
            for given in each.controller.own:
                if question.is_in(given.key.span) or question.is_in(given.value.at.span):
                    known = _known(each, given.name)
                    if known is not None:
                        owner = f"{each.type.type if each.type else each.name} ({distro})"
                        yield described_parameter(known, given.name, owner)
                    return


def _type(question: Question, each: Configured, distro: str) -> Iterator[str]:
    """What is known about the type of a controller at the place."""
    given = each.controller.type
    if given is None or not question.is_in(given.at.span):
        return
    if each.type is None:
        yield f"**controller type** `{given.text}`: not in the catalogue for {distro}"
        return
    lines = [f"**controller type** `{each.type.type}` ({distro}), in package `{each.type.package}`"]
    needed = [f"`{one.name}`" for one in each.type.parameters.values() if one.needed]
    lines.append(f"required parameters: {', '.join(needed)}" if needed else "no required parameters")
    yield "  \n".join(lines)


def _known(each: Configured, name: str) -> ParameterEntry | None:
    if each.type is None:
        return None
    found = matching(name, each.type.parameters)
    return each.type.parameters[found[0]] if found else None


# -- expressions -----------------------------------------------------------------------------------------------------


def _values(question: Question) -> Iterator[str]:
    """The values of the attribute at a place, one for each macro call and robot that gives another one."""
    found: dict[str, None] = {}
    written = ""
    for evaluated in question.evaluated():
        if question.is_in(evaluated.span):
            written = evaluated.span.text
            found[f"`{evaluated.value.replace(UNKNOWN, '?')}`{_called(evaluated.element)}"] = None
    if written:
        values = list(found)
        more = [f"- and {len(values) - _MOST_VALUES} more"] if len(values) > _MOST_VALUES else []
        yield "\n".join([f"`{written}` is", *(f"- {value}" for value in values[:_MOST_VALUES]), *more])


def _called(element: Element) -> str:
    call = next((call for call in element.call.chain() if call.kind == "macro"), None) if element.call else None
    if call is None:
        return ""
    line, _ = call.source.position(call.offset)
    return f" in the call of `{call.name}` in line {line}"
