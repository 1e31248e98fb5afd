"""The words of a node's command line that ROS 1 takes out of it: remappings, and private parameters.

`name:=value` is a remapping, `_name:=value` a parameter, `__name:=` and `__ns:=` are the node's own name and namespace
(rosgraph names.py: load_mappings; roscpp init.cpp, param.cpp). A node of ROS 2 takes them only after `--ros-args`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.migrate.launch.actions import Action, Text, is_literal, literal, plain

_MARK = ":="


def without_remappings(node: Action) -> Action:
    """Return a node whose command line has no remappings: they are its own instead."""
    given = list(_given(node.words))
    if not given:
        return node
    words = tuple(word for word in node.words if _divided(word) is None)
    remaps = tuple((old, new) for old, new in given if not plain(old).startswith("_"))
    named = {plain(old): new for old, new in given if is_literal(old)}
    pairs = tuple((name[1:], new) for name, new in named.items() if name.startswith("_") and name[1:2] != "_")
    name, space = named.get("__name", node.node_name), named.get("__ns", node.value)
    return node._replace(
        words=words,
        remaps=(*node.remaps, *remaps),
        pairs=(*node.pairs, *pairs),
        node_name=name,
        value=space,
    )


def _given(words: Sequence[Text]) -> Iterator[tuple[Text, Text]]:
    return (found for word in words if (found := _divided(word)) is not None)


def _divided(word: Text) -> tuple[Text, Text] | None:
    """The texts before and after the mark in a word; None if it has none."""
    for index, part in enumerate(word):
        old, mark, new = part.text.partition(_MARK) if part.kind == "text" else ("", "", "")
        if mark:
            return (*word[:index], *literal(old)), (*literal(new), *word[index + 1 :])
    return None
