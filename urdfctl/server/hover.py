"""What is shown when the user points at something: a name, a parameter, or an expression with its values."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.entries import Parameter
from urdfctl.catalog.map_parameters import matching
from urdfctl.control.session import Configured, session_of
from urdfctl.load.loader import LoadedTarget
from urdfctl.model.robot import Joint
from urdfctl.server.names import JOINT, LINK, Name
from urdfctl.server.navigation import NamesAround
from urdfctl.server.question import Question
from urdfctl.source.dom import Element
from urdfctl.source.opaque import UNKNOWN
from urdfctl.trace.uses import uses_of

_MOST_VALUES = 6
_MOST_USES = 12


def hover(question: Question) -> str | None:
    """Return what is known about a place, as Markdown; None if that is nothing."""
    parts = [*_parameter(question), *_name(question), *_values(question)]
    return "\n\n".join(dict.fromkeys(parts)) or None


# -- names -----------------------------------------------------------------------------------------------------------


def _name(question: Question) -> Iterator[str]:
    around = NamesAround(question._replace(robots=question.shown))
    if around.at is None:
        return
    for name in {(one.kind, one.text): one for one in around.all if one.span == around.at.span}.values():
        yield f"**{name.kind}** `{name.text}`{_scope(name)}"
        robot = next((each for each in question.robots if _element(each, name) is not None), None)
        if robot is not None:
            yield from _of_robot(robot, name)


def _scope(name: Name) -> str:
    return f" of macro `{name.scope}`" if name.scope else ""


def _element(robot: LoadedTarget, name: Name) -> Element | None:
    if robot.root is None or name.kind not in {JOINT, LINK}:
        return None
    children = robot.root.elements()
    return next((one for one in children if one.tagName == name.kind and one.attrs.get("name") == name.text), None)


def _of_robot(loaded: LoadedTarget, name: Name) -> Iterator[str]:
    element, robot = _element(loaded, name), loaded.project.robot
    if element is None or robot is None:
        return
    joint = next((one for one in robot.joints if one.name == name.text), None) if name.kind == JOINT else None
    if joint is not None:
        yield _joint(joint)
    uses = uses_of(loaded.project, element)
    lines = [f"- {use.kind} `{use.name}`: {use.how}" for use in uses[:_MOST_USES]]
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
    return ", ".join(words)


# -- parameters of controllers ---------------------------------------------------------------------------------------


def _parameter(question: Question) -> Iterator[str]:
    for loaded in question.robots:
        project = loaded.project
        if project.controllers is None or not project.distros:
            continue
        distro = project.distro or project.distros[-1]
        for each in session_of(project, distro).controllers:
            for given in each.controller.own:
                if question.is_in(given.key.span) or question.is_in(given.value.at.span):
                    known = _known(each, given.name)
                    if known is not None:
                        owner = f"{each.type.type if each.type else each.name} ({distro})"
                        yield described_parameter(known, given.name, owner)
                    return


def _known(each: Configured, name: str) -> Parameter | None:
    if each.type is None:
        return None
    found = matching(name, each.type.parameters)
    return each.type.parameters[found[0]] if found else None


def described_parameter(parameter: Parameter, name: str, owner: str) -> str:
    """Return what the catalogue knows about a parameter, as Markdown."""
    lines = [f"**parameter** `{name}` of {owner}", f"type: `{parameter.type}`"]
    if parameter.required:
        lines.append("required")
    elif parameter.default is not None:
        lines.append(f"default: `{parameter.default}`")
    lines += [f"{check}: `{limit}`" for check, limit in parameter.validators.items()]
    if parameter.deprecated:
        lines.append("deprecated" + (f"; use `{parameter.replacement}`" if parameter.replacement else ""))
    if parameter.ignored:
        lines.append("documented, but never read")
    if parameter.note:
        lines.append(parameter.note)
    return "  \n".join(lines)


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
