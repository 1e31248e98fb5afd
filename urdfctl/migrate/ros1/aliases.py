"""Aliases in controller files, which ROS 2 does not read, become the values of their anchors."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.controller_map import controller_maps
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.yaml.tree import Mapping, Node, Sequence, YamlFile, read_yaml
from urdfctl.startup.records import NamedTuple

_AUTHORITY = "rcl rcl_yaml_param_parser/src/parse.c: 'Will not support aliasing'"
_ALIAS = re.compile(r"[*&]([^\s,\[\]{}]+)")
_ANCHORS = re.compile(r"(?m)(?<=[:\-,])([ ]+)&[^\s,\[\]{}]+(?:[ ]|$)")
_KEY = re.compile(r"([ ]*)(?!<<)[^\s{\[-][^{\[]*:[ ]+")


class _Anchored(NamedTuple):
    """A node with an anchor: `value` is its text after the anchor, without anchors in it."""

    start: int
    name: str
    value: str


def _aliases(packages: MigratedPackages) -> Iterator[Proposal]:
    for source, _, _ in controller_maps(packages):
        file = read_yaml(source)
        anchored = list(_anchored(file.documents)) if file.aliases else []
        edits = [edit for at in file.aliases if (edit := _value(at, anchored)) is not None]
        if edits:
            edits += _without_anchors(file, anchored) if len(edits) == len(file.aliases) else []
            what = "the aliases are replaced by the values of their anchors"
            entry = ReportEntry(EntryKind.DONE, what, file.aliases[0], authority=_AUTHORITY)
            yield Proposal(tuple(edits), entries=(entry,))


def _anchored(documents: Iterable[Node]) -> Iterator[_Anchored]:
    """Yield the nodes with an anchor. An alias is the node of its anchor, so that each node is looked at once."""
    known: set[tuple[int, int]] = set()
    pending = list(documents)
    while pending:
        node = pending.pop()
        if (node.start, node.end) in known:
            continue
        known.add((node.start, node.end))
        text = node.source.data[node.start : _end(node)].decode("utf-8", "surrogateescape").rstrip()
        if text.startswith("&") and (found := _ALIAS.match(text)):
            yield _Anchored(node.start, found[1], _ANCHORS.sub(r"\1", text[found.end() :]))
        pending += [entry.value for entry in node.entries] if isinstance(node, Mapping) else []
        pending += node.items if isinstance(node, Sequence) else []


def _end(node: Node) -> int:
    """The end of a node; in block style that of its last line, which may be an alias."""
    data = node.source.data
    end = len(data[: node.end].rstrip())
    line_end = data.find(b"\n", end)
    is_block = b"\n" in data[node.start : end]
    return (len(data) if line_end < 0 else line_end) if is_block else end


def _value(at: Place, anchored: Iterable[_Anchored]) -> Edit | None:
    """The edit that writes the value of an alias; None if that has aliases itself, or needs another form."""
    data, start = at.source.data, at.start
    line = data.rfind(b"\n", 0, start) + 1
    found = _ALIAS.match(data[start:].decode("utf-8", "surrogateescape"))
    named = [one for one in anchored if found and one.name == found[1] and one.start < start]
    key = _KEY.fullmatch(data[line:start].decode("utf-8", "surrogateescape"))
    if found is None or not named or data[line:start].strip() == b"<<:":
        return None
    value, end = max(named).value, start + len(found.group().encode("utf-8", "surrogateescape"))
    if re.search(r"(?:^|[\s\[,])\*\w", value):
        return None
    if "\n" not in value:
        return Edit(SourceSpan(at.source, start, end), value.strip())
    if key is None or value.partition("\n")[0].strip():
        return None
    lines = [text for text in value.splitlines()[1:] if text.strip()]
    margin = min(len(text) - len(text.lstrip()) for text in lines)
    shown = "".join(f"\n{key[1]}  {text[margin:].rstrip()}" for text in lines)
    return Edit(SourceSpan(at.source, len(data[:start].rstrip(b" ")), end), shown)


def _without_anchors(file: YamlFile, anchored: Iterable[_Anchored]) -> Iterator[Edit]:
    """Yield the edits that remove the anchors, each with the blank before it."""
    for one in anchored:
        start, end = one.start, one.start + len(f"&{one.name}".encode("utf-8", "surrogateescape"))
        yield Edit(SourceSpan(file.source, len(file.source.data[:start].rstrip(b" ")), end), "")


ALIASES = Step(
    name="yaml-aliases",
    part=Part.YAML,
    summary="Aliases in controller files",
    propose=_aliases,
    generation=1,
    is_needed=True,
    rows=(Row("an alias *NAME in YAML", "the value of the anchor &NAME", "", _AUTHORITY),),
    before=[
        {
            "config/controllers.yaml": """
                left:
                  type: effort_controllers/JointPositionController
                  joint: shoulder
                  pid: &gains {p: 100.0, i: 0.0, d: 1.0}
                right:
                  type: effort_controllers/JointPositionController
                  joint: elbow
                  pid: *gains
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                left:
                  type: effort_controllers/JointPositionController
                  joint: shoulder
                  pid: {p: 100.0, i: 0.0, d: 1.0}
                right:
                  type: effort_controllers/JointPositionController
                  joint: elbow
                  pid: {p: 100.0, i: 0.0, d: 1.0}
            """,
        },
    ],
)
