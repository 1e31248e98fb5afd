"""The arguments to start a launch file with: those that are documented, and if it brings no robot together without any,
those that are guessed.

Values of a required argument come from the names of the files that exist: `urdf/$(arg model).urdf.xacro`.
"""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain, islice

from urdfctl.model.launch import Launch
from urdfctl.model.launch.parts import FILE_ENDINGS
from urdfctl.source.disk.gate import matching
from urdfctl.startup.records import NamedTuple

_MARK = "\ue001"
"""A value that no file name contains."""
_MOST_VALUES = 24
_MOST_REQUIRED = 8
_MOST_MODES = 8
_BOTH = ("true", "false")
_COMPARED = rb"==\s*[\"']([\w.-]+)[\"']"

Arguments = dict[str, str]
Read = Callable[[Mapping[str, str]], Launch | None]
"""Reads a launch file that is started with some arguments."""


class LaunchVariant(NamedTuple):
    """Arguments of a launch file.

    is_guessed: whether they are not the launch file's own defaults: a weaker reason to combine what it starts.
    """

    arguments: tuple[tuple[str, str], ...] = ()
    is_guessed: bool = False


def launch_variants(read: Read, documented: Iterable[Mapping[str, str]] = ()) -> list[LaunchVariant]:
    """Return the arguments to start a launch file with: none if it needs none, or if nothing is known about them; and
    those that are documented, where something else is started with them: guesses beside these must bring a robot.

    A launch file that finds its robot may still need an argument by which the robot's parameter files are loaded.
    """
    guesses = _guesses(read)
    told = _told(documented, guesses, read)
    if not told:
        return guesses
    default = read({})
    required = {name for name, value in default.arguments if value is None} if default else set()
    kept = [one for one in guesses if one.is_guessed and not _lacks(dict(one.arguments), required, told.values())]
    read_with = ((one, read(dict(one.arguments))) for one in kept)
    left = [one for one, other in read_with if other and other.robots and _started(other) not in told]
    if default is None or required:
        return [*told.values(), *left]
    return [LaunchVariant(), *(one for started, one in told.items() if started != _started(default)), *left]


def _lacks(guess: Arguments, required: set[str], told: Iterable[LaunchVariant]) -> bool:
    """Whether a documented choice has all of a guess, and another required argument."""
    choices = [dict(one.arguments) for one in told]
    return any(guess.items() <= choice.items() and required & (choice.keys() - guess.keys()) for choice in choices)


def _told(
    documented: Iterable[Mapping[str, str]], guesses: Iterable[LaunchVariant], read: Read
) -> dict[tuple[object, ...], LaunchVariant]:
    """The documented choices with which a robot is started whose files exist, by what is started with them."""
    told: dict[tuple[object, ...], LaunchVariant] = {}
    deciding = {name for one in guesses if one.is_guessed for name, _ in one.arguments}
    for arguments in documented:
        launch = read(arguments)
        if launch and launch.robots and _declares(launch, arguments) and _is_whole(launch):
            needed = {name for name, default in launch.arguments if not default} & deciding
            if needed <= arguments.keys():
                told.setdefault(_started(launch), LaunchVariant(tuple(arguments.items())))
    return told


def _started(launch: Launch | None) -> tuple[object, ...]:
    """What a launch file starts of robots and their controllers."""
    if launch is None:
        return ()
    described = ((one.file.path or one.file.text, one.arguments, one.namespace) for one in launch.robots)
    loads = (load.file.path for load in launch.loads if not load.in_node)
    spawns = (spawn.full_name(name) for spawn in launch.spawns for name, _ in spawn.names)
    return *described, *loads, *spawns, *(one.simulator for one in launch.simulations)


def _declares(launch: Launch, arguments: Mapping[str, str]) -> bool:
    return arguments.keys() <= {name for name, _ in launch.arguments}


def _guesses(read: Read) -> list[LaunchVariant]:
    launch = read({})
    if launch is None:
        return [LaunchVariant()]
    if launch.robots:
        missing = [name for name, default in launch.arguments if default is None][:_MOST_REQUIRED]
        choices = ([{name: value} for value in _values(name, {}, read)] for name in missing)
        found = next(filter(None, choices), None)
        return list(_combined(found, {}, [{}], read)) if found else [LaunchVariant()]
    required = [name for name, default in launch.arguments if not default][:_MOST_REQUIRED]
    required += _of_absent_file(launch)
    modes = [{}, *_modes(launch)]
    for mode in modes:
        for name in required:
            values = _values(name, mode, read)
            if values:
                return list(_combined([{name: value} for value in values], mode, modes, read))
        if mode and not required and _robots(mode, read):
            return [_guessed(mode)]
    return [LaunchVariant()]


def _of_absent_file(launch: Launch) -> list[str]:
    """The arguments whose defaults may be no more than what is to be replaced: `$(optenv ROBOT NO_ROBOT_SET)`, where
    the description is none that exists."""
    is_absent = any(each.file.path and not each.file.exists for each in launch.descriptions)
    names = [name for name, default in launch.arguments if "optenv" in (default or "")]
    return names[:_MOST_REQUIRED] if is_absent else []


def file_choices(launch: Launch, arguments: Mapping[str, str], read: Read) -> list[Arguments]:
    """Return other values of an argument with a default, by which other parameter files are loaded.

    E.g. `$(arg dof)dof_controllers.yaml`: the default is right for some of the robots.
    """
    paths = [load.file.path or "" for load in launch.loads]
    for name, default in launch.arguments:
        if default and name not in arguments and any(default in os.path.basename(path) for path in paths):
            marked = read({**arguments, name: _MARK})
            marks = (
                [load.file.text if load.file.path is None else load.file.path for load in marked.loads]
                if marked
                else []
            )
            values = {value for path in marks if _MARK in path for value in _in_files(path)} - {default}
            if values:
                return [{name: value} for value in sorted(values)[:_MOST_MODES]]
    return []


def variant_including(path: str, read: Read, text: bytes = b"") -> LaunchVariant:
    """Return the argument with which a launch file starts its robot and includes another launch file, one that is not
    its default: of those that it allows, the other one of true and false, one that its text compares with, or a part of
    the other file's name. None if there is none."""
    launch = read({})
    values = chain(_in_names(launch, path, read), _other_values(launch, text)) if launch else ()
    for name, value in islice(values, _MOST_VALUES):
        other = read({name: value})
        included = (one for one in other.references if one.use == "include" and one.sure) if other else ()
        if other and other.robots and any(one.file.path == path for one in included):
            return _guessed({name: value})
    return LaunchVariant()


def _in_names(launch: Launch, path: str, read: Read) -> Iterator[tuple[str, str]]:
    """Yield values of the arguments that are a part of the name of an included file."""
    for name, default in launch.arguments[:_MOST_REQUIRED]:
        marked = read({name: _MARK}) if default else None
        files = [one.file.path or "" for one in marked.references if one.use == "include"] if marked else []
        found = (_pattern(file).fullmatch(path) for file in files if _MARK in file)
        yield from ((name, match[1]) for match in found if match)


def _other_values(launch: Launch, text: bytes) -> Iterator[tuple[str, str]]:
    """Yield values of the arguments that are not their defaults."""
    choices = dict(launch.choices)
    compared = tuple(dict.fromkeys(value.decode() for value in re.findall(_COMPARED, text)))
    for name, default in launch.arguments:
        both = _BOTH if (default or "").lower() in _BOTH else compared if default else ()
        yield from ((name, value) for value in choices.get(name, both) if value.lower() != (default or "").lower())


def _modes(launch: Launch) -> Iterator[Arguments]:
    """The arguments that are off by default, each switched on."""
    off = [name for name, default in launch.arguments if (default or "").lower() in {"false", "0"}]
    yield from ({name: "true"} for name in off[:_MOST_MODES])


def _values(name: str, mode: Arguments, read: Read) -> list[str]:
    """The values of an argument with which the description of a robot exists, or its parameter files if the argument
    does not decide which description it is."""
    marked = read({**mode, name: _MARK})
    described = [one.file for one in marked.descriptions] if marked else []
    loaded = [each.file for each in marked.references if each.use == "parameters"] if marked else []
    values: list[str] = []
    for files in (described, loaded):
        paths = [file.path or file.text for file in files]
        values = values or [value for path in paths if _MARK in path for value in _in_files(path)]
    return sorted(dict.fromkeys(values), key=lambda value: (len(value), value))[:_MOST_VALUES]


def _in_files(path: str) -> Iterator[str]:
    """The texts that make a path with marks the path of a file; not of one with another ending, such as a backup."""
    if not os.path.isabs(path):
        return
    files = matching("*".join(map(glob.escape, path.split(_MARK))))
    matches = (_pattern(path).fullmatch(file) for file in files if file.endswith(FILE_ENDINGS))
    yield from (match[1] for match in matches if match)


def _pattern(path: str) -> re.Pattern[str]:
    """The paths that a path with marks means, with the text that is in the place of these."""
    first, *rest = map(re.escape, path.split(_MARK))
    return re.compile(first + r"([\w.-]+)" + r"\1".join(rest))


def _combined(bases: list[Arguments], mode: Arguments, modes: list[Arguments], read: Read) -> Iterator[LaunchVariant]:
    """Each value in the first mode that starts controllers, and the first value in every other one."""
    first = {**mode, **bases[0]}
    starting = [] if _controls(first, read) else [each for each in modes if _controls({**first, **each}, read)]
    complete = [{**base, **mode, **(starting[0] if starting else {})} for base in bases]
    whole = [arguments for arguments in complete if (launch := read(arguments)) and _is_whole(launch)]
    yield from map(_guessed, whole or complete)
    for other in starting[1:]:
        yield _guessed({**first, **other})


def _controls(arguments: Arguments, read: Read) -> bool:
    launch = read(arguments)
    return bool(launch and launch.robots and (launch.spawns or any(not load.in_node for load in launch.loads)))


def _is_whole(launch: Launch) -> bool:
    """Whether no file is missing that is loaded."""
    return not any(load.file.exists is False for load in launch.loads)


def _robots(arguments: Arguments, read: Read) -> bool:
    launch = read(arguments)
    return bool(launch and launch.robots)


def _guessed(arguments: Arguments) -> LaunchVariant:
    return LaunchVariant(tuple(arguments.items()), is_guessed=True)
