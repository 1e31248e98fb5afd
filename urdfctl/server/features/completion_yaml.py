"""What can be written at a place of a controller file or another YAML file of a robot."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence

from urdfctl.catalog.entries import ControllerType, ParameterEntry
from urdfctl.catalog.map_parameters import expanded, matching
from urdfctl.control.parameters.minimal import minimal_parameters
from urdfctl.control.session import session_of
from urdfctl.load.loader import LoadedTarget
from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.names import CONTROLLER, JOINT, LINK
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.trial import Trial
from urdfctl.server.analysis.xacro_names import PARAMETER
from urdfctl.server.features.about_parameters import described_parameter
from urdfctl.server.features.fitting import defined_names

_WORD = r"[\"']?(?P<word>[\w/.-]*)$"
_ELEMENT = r"[\w/.-]+"
_LISTS_CONTROLLERS = frozenset({"controller_names", "controllers", "chained_controllers", "fallback_controllers"})


def in_yaml(question: Question) -> Iterator[OfferedItem]:
    """Yield what can be written at a place."""
    line = question.before
    keys = _keys_above(question)
    if found := re.match(rf"\s*(?:- )?type:\s*{_WORD}", line):
        yield from _replacing(found["word"], _types(question))
    elif found := re.match(rf"\s*-\s*{_WORD}", line):
        yield from _listed(found["word"], _elements(question, keys, found["word"]))
    elif found := re.match(rf"\s*(?:- )?(?P<key>[\w./]+):\s*\[(?:[^\]]*[\s,\[])?{_WORD}", line):
        yield from _listed(found["word"], _elements(question, [*keys, found["key"]], found["word"]))
    elif found := re.match(r"\s*(?P<word>[\w.]*)$", line):
        yield from _replacing(found["word"], _parameters(question, keys))
    elif found := re.match(rf"\s*(?:- )?(?P<key>[\w./]+):(?P<gap>\s*){_WORD}", line):
        gap = "" if found["gap"] else " "
        for item in _replacing(found["word"], _scalars(question, [*keys, found["key"]])):
            yield item._replace(text=gap + item.text)


def _replacing(word: str, items: Iterator[OfferedItem]) -> Iterator[OfferedItem]:
    return (item._replace(replaces=len(word)) for item in items)


def _listed(word: str, items: Iterator[OfferedItem]) -> Iterator[OfferedItem]:
    return (item._replace(is_element=True) for item in _replacing(word, items))


def _keys_above(question: Question) -> list[str]:
    """The keys of the maps around a line, the outermost first."""
    indent = len(question.before) - len(question.before.lstrip())
    keys: list[str] = []
    is_list = question.before.lstrip().startswith("-")
    for number in range(question.line - 1, 0, -1):
        text = question.source.line(number)
        found = re.match(r"(\s*)(?:- )?([^\s#:][^:#]*):(?:\s|$)", text)
        if found and (len(found[1]) < indent or (is_list and len(found[1]) == indent and not keys)):
            indent = len(found[1])
            keys.insert(0, found[2].strip().strip("\"'"))
    return keys


# -- controllers -------------------------------------------------------------------------------------------------------


def _trials(question: Question) -> Iterator[Trial]:
    """The controllers of the robots that read the file, each to be tried with other values."""
    for robot in question.robots:
        project = robot.project
        if project.distros and project.controllers is not None:
            session = session_of(project, project.distro or project.distros[-1])
            joints = project.robot.joints if project.robot else ()
            moving = frozenset(joint.name for joint in joints if joint.moves and joint.name)
            yield from (Trial(session, each, moving) for each in session.controllers)


def _own(keys: list[str]) -> list[str]:
    return [key.rpartition("/")[2] for key in keys]


def _at(question: Question, keys: list[str]) -> Iterator[tuple[Trial, str]]:
    """The controllers whose parameter the keys lead to, with the parameter's full name or its beginning."""
    names = _own(keys)
    for trial in _trials(question):
        if trial.controller.name in names:
            inside = keys[names.index(trial.controller.name) + 1 :]
            yield trial, ".".join(key for key in inside if key != "ros__parameters")


def _types(question: Question) -> Iterator[OfferedItem]:
    """The types of the distro that fit a controller's parameters and claims, first those that need nothing else."""
    keys = [key for key in _own(_keys_above(question)) if key != "ros__parameters"]
    known_names = {"controller_manager", *(trial.controller.name for trial in _trials(question))}
    if known_names.isdisjoint(keys) and _has_other_types(question):
        return
    name, beside = keys[-1:], list(_keys_beside(question))
    for robot in question.robots:
        project = robot.project
        if not project.distros:
            continue
        distro = project.distro or project.distros[-1]
        found = (project.catalog.controller(each, distro) for each in project.catalog.known_types(distro))
        known = [kind for kind in found if kind is not None]
        trials = [trial for trial in _trials(question) if trial.controller.name in name]
        possible = _possible(known, trials, beside)
        for kind in sorted(possible, key=lambda one: any(trial.faults(one, _given(trial)) for trial in trials)):
            yield OfferedItem(kind.type, "type", f"a controller type of {distro}", is_doubtful=not trials)


def _has_other_types(question: Question) -> bool:
    """Whether a file has types, and none of them can be that of a controller: the planners of MoveIt, for example."""
    typed = re.search(r"[^\s\"'#]*$", question.before)
    begun, end = (len(typed[0].encode()) if typed else 0), question.offset
    others = question.source.data[: end - begun] + question.source.data[end:]
    found = re.findall(rb"^\s*type:[ \t]*[\"']?([\w:./-]+)", others, re.MULTILINE)
    return bool(found) and not any(b"/" in one for one in found)


def _given(trial: Trial) -> dict[str, object]:
    return {name: value for name, value in trial.values.items() if name not in {"type", "use_sim_time"}}


def _possible(
    kinds: Sequence[ControllerType], trials: Sequence[Trial], beside: Collection[str]
) -> list[ControllerType]:
    """The types that a controller can have: they fit its parameters best, or there are none yet.

    beside: the keys beside its type; they count if the controller is unknown without a type.
    """
    wrong = [sum(_misfits(kind, trial) for trial in trials) for kind in kinds]
    if not trials:
        wrong = [sum(matching(name, kind.parameters) is None for name in beside) for kind in kinds]
    return [kind for kind, number in zip(kinds, wrong, strict=True) if number == min(wrong)]


def _keys_beside(question: Question) -> Iterator[str]:
    """The other keys of the map that a line is in."""
    indent = len(question.before) - len(question.before.lstrip())
    last = question.source.data.count(b"\n") + 1
    for numbers in (range(question.line - 1, 0, -1), range(question.line + 1, last + 1)):
        for number in numbers:
            text = question.source.line(number)
            found = re.match(r"(\s*)([^\s#:][^:#]*):(?:\s|$)", text)
            if text.strip() and len(text) - len(text.lstrip()) < indent:
                break
            if found and len(found[1]) == indent:
                yield found[2].strip()


def _misfits(kind: ControllerType, trial: Trial) -> int:
    """How much is wrong with a controller of a type that is not wrong now."""
    given = _given(trial)
    return len(trial.faults(kind, given) - trial.now()) if given else 0


def _elements(question: Question, keys: list[str], word: str) -> Iterator[OfferedItem]:
    """Elements of a list: of a controller's parameter those with which nothing is wrong that is right now."""
    trials = [(trial, name) for trial, name in _at(question, keys) if trial.controller.type is not None]
    for trial, kind, name, declared in _declared(trials):
        now = trial.values.get(name) if question.is_current else _elements_around(question)
        given = [one for one in now if one and one != word] if isinstance(now, list) else []
        for choice in _choices(trial, kind.parameters[declared], declared):
            if choice not in given and trial.is_as_good(kind, {**trial.values, name: [*given, choice]}):
                yield OfferedItem(choice, _kind_of(trial, choice))
    if not trials:
        key = keys[-1] if keys else ""
        kinds = (CONTROLLER,) if key in _LISTS_CONTROLLERS else (JOINT,) if "joint" in key else ()
        listed = _elements_around(question)
        yield from (item for item in _named(question, *kinds) if item.text not in listed)


def _declared(trials: Iterable[tuple[Trial, str]]) -> Iterator[tuple[Trial, ControllerType, str, str]]:
    """Each trial with its controller's type, the parameter, and the name under which the type declares it."""
    for trial, name in trials:
        kind = trial.controller.type
        matched = matching(name, kind.parameters) if kind else None
        if kind is not None and matched is not None:
            yield trial, kind, name, matched[0]


def _elements_around(question: Question) -> list[str]:
    """The words of the list around the place, as it is written now: in brackets on one line, or below each other."""
    row = question.source.line(question.line).partition("[")[2].partition("]")[0]
    if row:
        return re.findall(_ELEMENT, row.partition(" #")[0])
    lines = [question.source.line(question.line)]
    for step in (-1, 1):
        number = question.line + step
        while re.match(r"\s*-\s", question.source.line(number)):
            lines.append(question.source.line(number))
            number += step
    return [found[1] for line in lines if (found := re.match(rf"\s*-\s*[\"']?({_ELEMENT})", line))]


def _kind_of(trial: Trial, choice: str) -> str:
    return JOINT if choice in trial.joints else "interface"


def _choices(trial: Trial, parameter: ParameterEntry, name: str) -> list[str]:
    """Texts that a parameter or its elements can be: what its validators name, joints, interfaces, or full names."""
    allowed = parameter.validators.get("one_of", parameter.validators.get("subset_of"))
    if isinstance(allowed, list | tuple):
        return [str(one) for one in allowed if isinstance(one, str)]
    hardware, kind = trial.session.hardware, trial.controller.type
    offers = [offer for found in (hardware.command, hardware.state) for each in found.values() for offer in each]
    interfaces = list(dict.fromkeys(offer.interface for offer in offers))
    rules = [rule for part in (kind.claims or ()) for rule in part] if kind else []
    if any(name == rule.names_from for rule in rules):
        return [f"{offer.component}/{offer.interface}" for offer in offers]
    if "interface" in name:
        return interfaces
    if kind is not None and (name in kind.joint_parameters or "joint" in name or "wheel" in name):
        components = list(dict.fromkeys(offer.component for offer in offers if offer.component in trial.joints))
        return components or sorted(trial.joints)
    return []


def _scalars(question: Question, keys: list[str]) -> Iterator[OfferedItem]:
    """A single value: what its parameter accepts; in other files, a joint or a link by the key."""
    trials = [(trial, name) for trial, name in _at(question, keys) if trial.controller.type is not None]
    for trial, kind, name, declared in _declared(trials):
        parameter = kind.parameters[declared]
        texts: list[object] = [True, False] if parameter.types == ("bool",) else []
        texts += _choices(trial, parameter, declared) if "string" in parameter.types else []
        for value in texts:
            if trial.is_as_good(kind, {**trial.values, name: value}):
                yield OfferedItem(_written(value), "value")
        if "frame" in name and "string" in parameter.types:
            yield from _named(question, LINK)
    key = keys[-1]
    if not trials and re.search(r"frame|link", key):
        yield from _named(question, LINK)
    elif not trials and key == "joint":
        yield from _named(question, JOINT)


def _named(question: Question, *kinds: str) -> Iterator[OfferedItem]:
    yield from (OfferedItem(name.text, name.kind) for name in defined_names(question, *kinds))


# -- parameters --------------------------------------------------------------------------------------------------------


def _parameters(question: Question, keys: list[str]) -> Iterator[OfferedItem]:
    for robot in question.robots:
        joints = _commanded(robot)
        for trial, prefix in _at(question, keys):
            yield from _of_controller(trial, prefix, joints)


def _commanded(robot: LoadedTarget) -> list[str]:
    """The joints that hardware commands, or that move if nothing is known of hardware."""
    model = robot.project.robot
    if model is None:
        return []
    parts = [part for component in model.ros2_controls for part in component.of_kind("joint") if part.commands]
    moving = [joint.name for joint in model.joints if joint.moves and joint.name and not joint.mimic]
    return [part.name for part in parts if part.name] or moving


def _of_controller(trial: Trial, prefix: str, joints: list[str]) -> Iterator[OfferedItem]:
    """The parameters that a controller does not have yet, below the keys that are written already.

    Each has a value of its type with which nothing is wrong that is right now, or none if none is known.
    joints: what a parameter that lists joints is offered with.
    """
    each, distro = trial.controller, trial.session.distro
    if each.type is None:
        return
    below = f"{prefix}." if prefix else ""
    examples = minimal_parameters(each.type)
    for name, parameter in each.type.parameters.items():
        if parameter.ignored or parameter.deprecated or parameter.type == "none":
            continue
        for full in expanded(name, trial.values):
            rest = full.removeprefix(below)
            if full.startswith(below) and "." not in rest and full not in trial.values:
                value = _value(trial, name, full, [joints, examples.get(name), parameter.default])
                about = described_parameter(parameter, full, f"{each.type.type} ({distro})")
                yield OfferedItem(f"{rest}: {_written(value)}".rstrip(), PARAMETER, about)


def _value(trial: Trial, name: str, full: str, candidates: list[object]) -> object:
    """The first value with which the controller is as good as it is now; None if there is none."""
    each = trial.controller
    parameter = each.type.parameters[name] if each.type else None
    if each.type is None or parameter is None:
        return None
    of_joints = name in ("joints", *each.type.joint_parameters) and parameter.type == "string_array"
    choices = _choices(trial, parameter, name)
    interfaces: list[object] = [[one] for one in choices] if "interface" in name else []
    joints, example, default = candidates
    known = [default] if _is_made_up(example, choices) else [example, default]
    for value in [*([joints] if of_joints else []), *known, *interfaces]:
        if value not in (None, []) and trial.is_as_good(each.type, {**trial.values, full: value}):
            return value
    return None


def _is_made_up(example: object, choices: Sequence[str]) -> bool:
    """Return whether an example has texts that the robot does not know, such as the name of a joint."""
    texts = example if isinstance(example, list | tuple) else [example]
    return any(isinstance(one, str) and one not in choices for one in texts)


def _written(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list | tuple):
        return f"[{', '.join(_written(one) for one in value)}]"
    if isinstance(value, str):
        return f'"{value}"' if not value or not re.fullmatch(r"[A-Za-z_][\w/-]*", value) else value
    return "" if value is None else str(value)
