"""Find the launch files and controller files in folders that are linted."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from urdfctl.discover.walk import LAUNCHES, text_of
from urdfctl.source.disk.gate import is_file

if TYPE_CHECKING:
    from urdfctl.discover.included import Included

_RELEVANT = rb"<rosparam\b|[\"']controller_manager[\"']|\bros2 control\b|[\"'] *control(?:[\"']| +(?:load|set)_)"
_DESCRIBING = rb"\brobot_state_publisher\b|\brobot_description\b|pkg:\s*controller_manager"
_PLANNING = rb"\bmoveit_ros_move_group\b|\bgenerate_(?:demo|move_group|rsp|spawn_controllers)_launch\b"
_SIMULATING = rb"\b(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo)\b"
_ARGUMENTS = rb"<arg\b|\$\((?:var|arg)\b|\bLaunchConfiguration|\blaunch_configurations\b|(?m:^\s*-\s*arg:)"
_DEMO = rb"\bgenerate_demo_launch\b"
_ONLY_INCLUDED = ".launch.xml"
"""The ending of launch files for ROS 1 that are only included."""
_OF_ROS2 = rb"\$\((?:find-pkg-share|var)\b|\bexec\s*="
_IMPORT = rb"(?m)^[ \t]*(?:from|import)[ \t]+(\w+)"
_INSTALLED = frozenset((b"ament_index_python", b"launch", b"launch_ros", b"os", b"pathlib", b"sys", b"xacro", b"yaml"))
"""The modules that most launch files import, and that no module beside one of them is."""
_ROS2 = (".py", ".yaml", ".yml")
_PARAMETERS = rb"(?m)^[ \t]*[\"']?ros__parameters[\"']?[ \t]*:"
_MANAGER = rb"(?m)^[ \t]*[\"']?[\w/*]*\bcontroller_manager[\"']?[ \t]*:"
_TYPE = rb"(?m)(?:^[ \t]*|[{,][ \t]*)[\"']?type[\"']?[ \t]*:[ \t]*[\"']?\w*(?:controller|broadcaster)\w*/\w"
_XML = rb"(?s)\s*(?:<[?!][^<>]{0,2000}>\s*){0,9}<launch\b"
_TEMPLATE = rb"\{\{|\{%|<%"
_MOST_BYTES = 1 << 18
_MOST_BRACES = 10_000
"""Python needs time that grows with the square of the values in an f-string, until 3.12."""
_MOST_TEXTS = 512
_ONLY_PARSE = 0x400  # ast.PyCF_ONLY_AST, without the import of ast


def is_controllers_file(text: bytes) -> bool:
    """Return whether a YAML text configures controllers: it has a manager's section, or types of controllers.

    Templates are not: they are not YAML until they are filled in.
    """
    if re.search(_TEMPLATE, text):
        return False
    managed = re.search(_PARAMETERS, text) and re.search(_MANAGER, text)
    return bool(managed or re.search(_TYPE, text))


def may_launch(path: str) -> bool:
    """Return whether a file may be a launch file: by its name, or because it is Python in a folder of that name."""
    return path.endswith((*LAUNCHES, ".py"))


def is_launch_file(path: str, text: bytes) -> bool:
    """Return whether a file in a folder is a launch file. One in XML with a name for Python is, and is broken."""
    if path.endswith(".py"):
        is_misnamed = path.endswith(LAUNCHES) and re.match(_XML, text) is not None
        return b"def generate_launch_description" in text or is_misnamed
    return bool(re.search(rb"(?m)^launch[ \t]*:", text)) if path.endswith(_ROS2) else b"<launch" in text


@lru_cache(maxsize=_MOST_TEXTS)
def is_broken(path: str, text: bytes) -> bool:
    """Return whether a launch file in Python or XML has a syntax error. Templates, and large files, count as sound."""
    if len(text) > _MOST_BYTES or path.endswith((".yaml", ".yml")) or re.search(_TEMPLATE, text):
        return False
    return _is_broken_python(text) if path.endswith(".py") else _is_broken_xml(text)


def _is_broken_python(text: bytes) -> bool:
    import warnings

    if text.count(b"{") > _MOST_BRACES:
        return False
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            compile(text, "launch", "exec", _ONLY_PARSE)
        except SyntaxError:
            return True
        except (ValueError, RecursionError, MemoryError):
            return False
    return False


def _is_broken_xml(text: bytes) -> bool:
    from xml.parsers import expat

    parser = expat.ParserCreate()
    try:
        parser.Parse(text, True)  # noqa: FBT003 (its only form)
    except expat.ExpatError:
        return True
    return False


def launch_roots(texts: Mapping[str, bytes], naming: Sequence[bytes] = ()) -> list[str]:
    """The launch files that no other one without a syntax error certainly includes, and which describe a robot, load
    parameters or start controllers, themselves or by what they include, also elsewhere, in order.

    naming: if given, only those which also name one of these, themselves or by what they include.
    """
    named = {path for name in naming for path, text in texts.items() if name in text} if naming else {*texts}
    if not named:
        return []
    from urdfctl.discover.included import included_in

    by_name: dict[str, list[str]] = {}
    for path in texts:
        by_name.setdefault(os.path.basename(path), []).append(path)
    found = {path: included_in(path, text, by_name) for path, text in texts.items()}
    including = (path for path, included in found.items() if included.sure and not is_broken(path, texts[path]))
    inner = {included for path in including for included in found[path].sure}
    return [path for path in texts if path not in inner and _is_relevant(path, found, texts, named)]


def only_mentioned(texts: Mapping[str, bytes], started: Collection[str]) -> list[str]:
    """Return the launch files that start robots themselves, and that only the texts of others seem to include: whether
    one of these does is known when they are followed. MoveIt's demo includes those beside it."""
    demos = {os.path.dirname(path) for path, text in texts.items() if re.search(_DEMO, text)}
    inner = (path for path, text in texts.items() if path not in started and not _is_only_included(path, text))
    return [path for path in inner if _starts_robots(texts[path]) and not (demos and _is_of_demo(path, demos))]


def takes_arguments(path: str) -> bool:
    """Return whether a launch file may start something else if another one includes it with arguments."""
    return re.search(_ARGUMENTS, text_of(path)) is not None


def _is_of_demo(path: str, demos: Collection[str]) -> bool:
    from urdfctl.discover.included import OF_DEMO

    folder, name = os.path.split(path)
    return folder in demos and name.partition(".")[0] in OF_DEMO


def _is_only_included(path: str, text: bytes) -> bool:
    """Whether the ending of a launch file says that others include it: in ROS 2 it is that of all files in XML."""
    return path.endswith(_ONLY_INCLUDED) and re.search(_OF_ROS2, text) is None


@lru_cache(maxsize=_MOST_TEXTS)
def _starts_robots(text: bytes) -> bool:
    """Whether a launch file describes a robot, loads parameters, starts controllers or plans for a robot itself."""
    return any(re.search(pattern, text) for pattern in (_RELEVANT, _DESCRIBING, _PLANNING, _SIMULATING))


def _is_helped(path: str, text: bytes) -> bool:
    """Whether a launch file in Python imports a module beside it that starts robots."""
    names = {*re.findall(_IMPORT, text)} - _INSTALLED if path.endswith(".py") else ()
    beside = (os.path.join(os.path.dirname(path), f"{name.decode()}.py") for name in sorted(names))
    return any(_starts_robots(text_of(module)) for module in beside if is_file(module))


def _is_relevant(
    path: str, included: Mapping[str, Included], texts: Mapping[str, bytes], named: Collection[str]
) -> bool:
    """Whether a launch file or one that it includes starts robots, and it or one that it includes is in `named`."""
    pending, seen = [path], {path}
    starts, names = False, False
    while pending:
        current = pending.pop()
        starts = starts or included[current].elsewhere or _starts_robots(texts[current])
        starts = starts or _is_helped(current, texts[current])
        names = names or current in named
        if starts and names:
            return True
        new = [other for other in included[current].every if other not in seen]
        seen.update(new)
        pending += new
    return False
