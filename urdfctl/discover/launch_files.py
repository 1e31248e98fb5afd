"""Find the launch files and controller files in folders that are linted."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache

from urdfctl.discover.walk import LAUNCHES

_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_INCLUDE = rb"(?s)<include\s[^<>]*?file\s*=\s*[\"']([^\"']+)[\"']"
_NAMED = (
    rb"[\"'/]([\w.-]+[._]launch\.(?:py|xml|ya?ml))[\"']"
    rb"|file:[^\n#]{0,300}?/([\w.-]{1,100}[._]launch\.(?:py|xml|ya?ml))\b"
)
_RELEVANT = rb"<rosparam\b|[\"']controller_manager[\"']|\bros2 control\b|[\"']control[\"']"
_DESCRIBING = rb"\brobot_state_publisher\b|\brobot_description\b|pkg:\s*controller_manager"
_PLANNING = rb"\bmoveit_ros_move_group\b|\bgenerate_(?:demo|move_group|rsp|spawn_controllers)_launch\b"
_SIMULATING = rb"\b(?:gazebo_ros|ros_gz_sim|ros_ign_gazebo)\b"
_DEMO = rb"\bgenerate_demo_launch\b"
_OF_DEMO = "static_virtual_joint_tfs rsp move_group moveit_rviz warehouse_db spawn_controllers".split()
"""The launch files of its package that MoveIt's demo includes (moveit_configs_utils, launches.py)."""
_ROS2 = (".py", ".yaml", ".yml")
_PARAMETERS = rb"(?m)^[ \t]*[\"']?ros__parameters[\"']?[ \t]*:"
_MANAGER = rb"(?m)^[ \t]*[\"']?[\w/*]*\bcontroller_manager[\"']?[ \t]*:"
_TYPE = rb"(?m)(?:^[ \t]*|[{,][ \t]*)[\"']?type[\"']?[ \t]*:[ \t]*[\"']?\w*(?:controller|broadcaster)\w*/\w"
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
    """Return whether a file in a folder is a launch file."""
    if path.endswith(".py"):
        return b"def generate_launch_description" in text
    return bool(re.search(rb"(?m)^launch[ \t]*:", text)) if path.endswith(_ROS2) else b"<launch" in text


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
    """The launch files that no other one includes, and which describe a robot, load parameters or start controllers,
    themselves or by what they include, in order.

    naming: if given, only those which also name one of these, themselves or by what they include.
    """
    named = {path for name in naming for path, text in texts.items() if name in text} if naming else {*texts}
    if not named:
        return []
    by_name: dict[str, list[str]] = {}
    for path in texts:
        by_name.setdefault(os.path.basename(path), []).append(path)
    included = {path: list(_included(path, text, by_name)) for path, text in texts.items()}
    inner = {path for paths in included.values() for path in paths}
    return [path for path in texts if path not in inner and _is_relevant(path, included, texts, named)]


def _included(path: str, text: bytes, by_name: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """Yield the files that a launch file may include: those whose path ends like the included one."""
    if path.endswith(_ROS2):
        yield from _named(path, text, by_name)
        return
    for tail in _tails(text):
        for candidate in by_name.get(tail.rpartition("/")[2], ()):
            if candidate != path and _with_slashes(candidate, os.getcwd()).endswith(f"/{tail}"):
                yield candidate


@lru_cache(maxsize=_MOST_TEXTS)
def _tails(text: bytes) -> tuple[str, ...]:
    """The ends of the paths that an XML launch file includes. Texts are kept: each package's search reads them."""
    addresses = re.findall(_INCLUDE, re.sub(_COMMENT, b"", text))
    decoded = (address.decode("utf-8", "replace") for address in addresses)
    return tuple(re.sub(r"^.*\$\([^)]*\)+/?", "", address).lstrip("./") for address in decoded)


@lru_cache(maxsize=_MOST_TEXTS)
def _with_slashes(path: str, current: str) -> str:
    """A path relative to the current folder, from the root."""
    return "/" + os.path.normpath(os.path.join(current, path)).replace(os.sep, "/")


@lru_cache(maxsize=_MOST_TEXTS)
def _launch_names(text: bytes) -> tuple[str, ...]:
    """The names of launch files in a Python or YAML launch file."""
    names = [(one or other).decode("utf-8", "replace") for one, other in re.findall(_NAMED, text)]
    return (*names, *(f"{name}.launch.py" for name in _OF_DEMO if re.search(_DEMO, text)))


@lru_cache(maxsize=_MOST_TEXTS)
def _starts_robots(text: bytes) -> bool:
    """Whether a launch file describes a robot, loads parameters, starts controllers or plans for a robot itself."""
    return any(re.search(pattern, text) for pattern in (_RELEVANT, _DESCRIBING, _PLANNING, _SIMULATING))


def _named(path: str, text: bytes, by_name: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """Yield the launch files that a Python or YAML launch file names.

    If several files have the name: those in a folder that it names too, or else those in its own folder.
    """
    for name in _launch_names(text):
        candidates = [candidate for candidate in by_name.get(name, ()) if candidate != path]
        beside = [candidate for candidate in candidates if os.path.dirname(candidate) == os.path.dirname(path)]
        in_named_folder = [
            path for path in candidates if any(part.encode() in text for part in path.split(os.sep)[-3:-2])
        ]
        yield from candidates if len(candidates) == 1 else in_named_folder or beside or candidates


def _is_relevant(
    path: str, included: Mapping[str, Iterable[str]], texts: Mapping[str, bytes], named: Collection[str]
) -> bool:
    """Whether a launch file or one that it includes starts robots, and it or one that it includes is in `named`."""
    pending, seen = [path], {path}
    starts, names = False, False
    while pending:
        current = pending.pop()
        starts = starts or _starts_robots(texts[current])
        names = names or current in named
        if starts and names:
            return True
        new = [other for other in included[current] if other not in seen]
        seen.update(new)
        pending += new
    return False
