"""The paths of nodes in parameter files: with wildcards, as in rclcpp's parameter_map.cpp, and with placeholders."""

from __future__ import annotations

import re

PLACEHOLDER = re.compile(r"<[A-Za-z_][\w.-]*>|\{\{[^{}]*\}\}")
"""What a launch file replaces in a path."""
_PARTS = re.compile(r"(/\*\*|/\*|/?(?:<[A-Za-z_][\w.-]*>|\{\{[^{}]*\}\}))")
_ANY, _ONE = "/**", "/*"
_MOST_PARTS = 100


def matches(path: str, node: str) -> bool:
    """Return whether a path applies to a node, given by its full name.

    `/**` stands for any number of names with a slash before them, `/*` for one, and a placeholder for any.
    """
    parts = _PARTS.split(path)
    if len(parts) > _MOST_PARTS or sum(map(len, parts[::2])) > len(node):
        return False
    ends = {0}
    for number, part in enumerate(parts):
        if number % 2 == 0:
            ends = {end + len(part) for end in ends if node.startswith(part, end)}
        elif part in (_ANY, _ONE):
            names = _after_names(node, ends, many=part == _ANY)
            ends = ends | names if part == _ANY else names
        else:
            ends = _after_any(node, ends)
        if not ends:
            return False
    return len(node) in ends


def _after_names(node: str, starts: set[int], *, many: bool) -> set[int]:
    """Where one name, or many, with a slash before each, can end that begin at one of the starts."""
    ends: set[int] = set()
    for index, letter in enumerate(node):
        if letter == "/":
            if (index in starts or (many and index in ends)) and _is_of_name(node[index + 1 : index + 2]):
                ends.add(index + 2)
        elif index in ends and _is_of_name(letter):
            ends.add(index + 1)
    return ends


def _after_any(node: str, starts: set[int]) -> set[int]:
    """Where names and slashes can end that begin at one of the starts."""
    ends = set(starts)
    for index, letter in enumerate(node):
        if index in ends and (letter == "/" or _is_of_name(letter)):
            ends.add(index + 1)
    return ends


def _is_of_name(letter: str) -> bool:
    return letter.isalnum() or letter == "_"
