"""Finds, in the folders of a command line, the launch files and controllers' files that may be worth linting."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_INCLUDE = rb"(?s)<include\s[^<>]*?file\s*=\s*[\"']([^\"']+)[\"']"
_NAMED = rb"[\"'/]([\w.-]+[._]launch\.(?:py|xml|ya?ml))[\"']|file:[ \t]*\S{0,300}/([\w.-]{1,100}\.launch\.\w{1,5})"
_RELEVANT = rb"<rosparam\b|[\"']controller_manager[\"']|\bros2 control\b|[\"']control[\"']"
_DESCRIBING = rb"\brobot_state_publisher\b|\brobot_description\b|pkg:\s*controller_manager"
_ROS2 = (".py", ".yaml", ".yml")
_PARAMETERS = rb"(?m)^[ \t]*[\"']?ros__parameters[\"']?[ \t]*:"
_MANAGER = rb"(?m)^[ \t]*[\"']?[\w/*]*\bcontroller_manager[\"']?[ \t]*:"
_TYPE = rb"(?m)(?:^[ \t]*|[{,][ \t]*)[\"']?type[\"']?[ \t]*:[ \t]*[\"']?\w*(?:controller|broadcaster)\w*/\w"
_TEMPLATE = rb"\{\{|\{%|<%"


def is_controllers_file(text: bytes) -> bool:
    """Whether a YAML text configures controllers: by a manager's section, or by types as controllers have them. A
    template is none: it is no YAML before it is filled in."""
    if re.search(_TEMPLATE, text):
        return False
    managed = re.search(_PARAMETERS, text) and re.search(_MANAGER, text)
    return bool(managed or re.search(_TYPE, text))


def is_launch_file(path: str, text: bytes) -> bool:
    """Whether a file that is found in a folder is a launch file."""
    if path.endswith(".py"):
        return b"def generate_launch_description" in text
    return bool(re.search(rb"(?m)^launch[ \t]*:", text)) if path.endswith(_ROS2) else b"<launch" in text


def launch_roots(texts: Mapping[str, bytes]) -> list[str]:
    """The launch files that no other one includes, and which describe a robot, load parameters or start controllers,
    themselves or by what they include, in order."""
    by_name: dict[str, list[str]] = {}
    for path in texts:
        by_name.setdefault(os.path.basename(path), []).append(path)
    included = {path: list(_included(path, text, by_name)) for path, text in texts.items()}
    inner = {path for paths in included.values() for path in paths}
    return [path for path in texts if path not in inner and _is_relevant(path, included, texts)]


def _included(path: str, text: bytes, by_name: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """The files of a folder that a launch file may include: those whose path ends as the address does."""
    if path.endswith(_ROS2):
        yield from _named(path, text, by_name)
        return
    for match in re.finditer(_INCLUDE, re.sub(_COMMENT, b"", text)):
        address = match.group(1).decode("utf-8", "replace")
        tail = re.sub(r"^.*\$\([^)]*\)+/?", "", address).lstrip("./")
        for candidate in by_name.get(os.path.basename(tail), ()):
            if candidate != path and f"/{os.path.abspath(candidate)}".replace(os.sep, "/").endswith(f"/{tail}"):
                yield candidate


def _named(path: str, text: bytes, by_name: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """The launch files whose names stand in one of Python or YAML: where several have a name, those of its own folder,
    else those in a folder that it names too."""
    for match in re.finditer(_NAMED, text):
        name = (match.group(1) or match.group(2)).decode("utf-8", "replace")
        candidates = [candidate for candidate in by_name.get(name, ()) if candidate != path]
        beside = [candidate for candidate in candidates if os.path.dirname(candidate) == os.path.dirname(path)]
        told = [one for one in candidates if any(part.encode() in text for part in one.split(os.sep)[-3:-2])]
        yield from candidates if len(candidates) == 1 else told or beside or candidates


def _is_relevant(path: str, included: Mapping[str, Iterable[str]], texts: Mapping[str, bytes]) -> bool:
    pending, seen = [path], {path}
    while pending:
        current = pending.pop()
        if re.search(_RELEVANT, texts[current]) or re.search(_DESCRIBING, texts[current]):
            return True
        new = [other for other in included[current] if other not in seen]
        seen.update(new)
        pending += new
    return False
