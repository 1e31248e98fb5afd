"""Finds, in the folders of a command line, the launch files and controllers' files that may be worth linting."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping

_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_INCLUDE = rb"(?s)<include\s[^<>]*?file\s*=\s*[\"']([^\"']+)[\"']"
_RELEVANT = rb"<rosparam\b|[\"']controller_manager[\"']"
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


def launch_roots(texts: Mapping[str, bytes]) -> list[str]:
    """The launch files that no other one includes, and which load parameters or start controllers themselves or by
    what they include, in order."""
    by_name: dict[str, list[str]] = {}
    for path in texts:
        by_name.setdefault(os.path.basename(path), []).append(path)
    included = {path: list(_included(path, text, by_name)) for path, text in texts.items()}
    inner = {path for paths in included.values() for path in paths}
    return [path for path in texts if path not in inner and _is_relevant(path, included, texts)]


def _included(path: str, text: bytes, by_name: Mapping[str, Iterable[str]]) -> Iterator[str]:
    """The files of a folder that a launch file may include: those whose path ends as the address does."""
    for match in re.finditer(_INCLUDE, re.sub(_COMMENT, b"", text)):
        address = match.group(1).decode("utf-8", "replace")
        tail = re.sub(r"^.*\$\([^)]*\)+/?", "", address).lstrip("./")
        for candidate in by_name.get(os.path.basename(tail), ()):
            if candidate != path and f"/{os.path.abspath(candidate)}".replace(os.sep, "/").endswith(f"/{tail}"):
                yield candidate


def _is_relevant(path: str, included: Mapping[str, Iterable[str]], texts: Mapping[str, bytes]) -> bool:
    pending, seen = [path], {path}
    while pending:
        current = pending.pop()
        if re.search(_RELEVANT, texts[current]):
            return True
        new = [other for other in included[current] if other not in seen]
        seen.update(new)
        pending += new
    return False
