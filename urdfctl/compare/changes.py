"""The changes from one robot to another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.compare.names import RenamedParts, renamed
from urdfctl.compare.tree import TreeNode, is_same
from urdfctl.startup.records import NamedTuple

AREAS = (
    "links", "joints", "limits", "inertials", "geometry", "interfaces", "transmissions", "hardware", "controllers",
    "plugins", "sensors", "simulation", "moveit", "started", "other",
)  # fmt: skip
"""What a change can be about, in the order of reports."""
_BY_PART = {
    "link": "links", "joint": "joints", "transmission": "transmissions", "ros2_control": "hardware",
    "gazebo": "simulation",
    "controller": "controllers", "manager": "controllers", "node": "controllers", "moveit_limits": "limits",
    "group": "moveit", "started": "started", "node_started": "started", "simulator_started": "started",
    "material": "geometry",
}  # fmt: skip
_BY_TAG = {
    "limit": "limits", "safety_controller": "limits", "inertial": "inertials", "visual": "geometry",
    "collision": "geometry", "plugin": "plugins", "sensor": "sensors",
}  # fmt: skip
_IN_HARDWARE = {"joint": "interfaces", "sensor": "interfaces", "gpio": "interfaces", "transmission": "transmissions"}


class RobotChange(NamedTuple):
    """A difference between two robots.

    area: one of AREAS.
    kind: added, removed, renamed, moved or changed.
    path: the labels of the parts that lead to it, such as `joint:elbow` and `limit`.
    attribute: the attribute that changed; empty for a text or a whole part.
    before, after: the values; None if there is none.
    """

    area: str
    kind: str
    path: tuple[str, ...]
    attribute: str = ""
    before: str | None = None
    after: str | None = None

    @property
    def address(self) -> str:
        """Where it is in the robot: in the new one, unless it was removed."""
        return "/".join([*self.path, *([f"@{self.attribute}"] if self.attribute else [])])


def changes(before: TreeNode, after: TreeNode) -> list[RobotChange]:
    """Return the changes from one robot to another, in the order of AREAS and then of the new robot."""
    names = renamed(before, after)
    found = [
        *(_renamed("link", old, new) for old, new in names.links.items()),
        *(_renamed("joint", old, new) for old, new in names.joints.items()),
        *_Comparison(names).between(before, after, ()),
    ]
    return sorted(found, key=lambda change: AREAS.index(change.area))


def _renamed(tag: str, old: str, new: str) -> RobotChange:
    return RobotChange(_BY_PART[tag], "renamed", (f"{tag}:{new}",), before=old, after=new)


class _Comparison:
    """Compares parts of two robots. A text of the old robot is also the same if it has the new name of something."""

    def __init__(self, names: RenamedParts) -> None:
        self._names = names

    def between(self, before: TreeNode, after: TreeNode, path: tuple[str, ...]) -> Iterator[RobotChange]:
        """Yield the changes from one part to another."""
        old_values = {self._name_in(name, after.values): value for name, value in before.values.items()}
        for name in dict.fromkeys([*old_values, *after.values]):
            old, new = old_values.get(name), after.values.get(name)
            if old is None or new is None or not self._is_same(after.tag, name, old, new):
                kind = "moved" if path and (path[-1], name) == ("parent", "link") else "changed"
                yield RobotChange(_area(path), kind, path, attribute=name, before=old, after=new)
        groups: dict[str, tuple[list[TreeNode], list[TreeNode]]] = {child.label: ([], []) for child in after.children}
        for child in before.children:
            groups.setdefault(self._label_in(child, groups), ([], []))[0].append(child)
        for child in after.children:
            groups[child.label][1].append(child)
        for label, (old_ones, new_ones) in groups.items():
            yield from self._among(old_ones, new_ones, (*path, label))

    def _among(self, before: list[TreeNode], after: list[TreeNode], path: tuple[str, ...]) -> Iterator[RobotChange]:
        """The changes among parts with the same label: equal ones are the same, the others in their order."""
        several = len(before) > 1 or len(after) > 1
        numbers = {id(node): number for number, node in enumerate(after, 1)}
        if several:
            before, after = self._without_equal(before, after)
        for old, new in zip(before, after, strict=False):
            yield from self.between(old, new, (*path[:-1], f"{path[-1]}[{numbers[id(new)]}]") if several else path)
        for node in before[len(after) :]:
            yield RobotChange(_area(path), "removed", path, before=summary(node))
        for node in after[len(before) :]:
            yield RobotChange(_area(path), "added", path, after=summary(node))

    def _without_equal(
        self, before: Sequence[TreeNode], after: Sequence[TreeNode]
    ) -> tuple[list[TreeNode], list[TreeNode]]:
        rest, left = list(after), []
        for node in before:
            same = next((other for other in rest if not any(self.between(node, other, ()))), None)
            if same is None:
                left.append(node)
            else:
                rest.remove(same)
        return left, rest

    def _is_same(self, tag: str, attribute: str, old: str, new: str) -> bool:
        return is_same(old, new) or is_same(self._names.of(tag, attribute, old), new)

    def _label_in(self, node: TreeNode, labels: Mapping[str, object]) -> str:
        """The label of an old part, with the new name if only that is known."""
        if node.label in labels:
            return node.label
        label = node._replace(key=self._names.of(node.tag, "name", node.key)).label
        return label if label in labels else node.label

    def _name_in(self, name: str, names: Mapping[str, object]) -> str:
        """The name of an old value, such as `gains.elbow.p`, with new names if only that is known."""
        new = name if name in names else ".".join(self._names.of("", "", part) for part in name.split("."))
        return new if new in names else name


def _area(path: tuple[str, ...]) -> str:
    tags = [label.partition(":")[0].partition("[")[0] for label in path]
    if not tags:
        return "other"
    if tags[0] == "ros2_control":
        return _IN_HARDWARE.get(tags[1], "hardware") if len(tags) > 1 else "hardware"
    if tags[0] in {"link", "joint", "gazebo"}:
        inner = next((_BY_TAG[tag] for tag in tags[1:] if tag in _BY_TAG), None)
        return inner or _BY_PART[tags[0]]
    return _BY_PART.get(tags[0], _BY_TAG.get(tags[0], "other"))


def summary(node: TreeNode) -> str:
    """Return what is worth knowing of a part that was added or removed."""
    ends = {child.tag: child.values.get("link", "") for child in node.children if child.tag in {"parent", "child"}}
    if node.tag == "joint" and ends:
        return f"{node.values.get('type', '')}, {ends.get('parent', '?')} to {ends.get('child', '?')}"
    values = [value if not name else f"{name}={value}" for name, value in node.values.items() if name not in _NAMING]
    if node.tag in {"controller", "transmission"}:
        texts = (child.values.get("", "") for child in node.children if child.tag == "type")
        return node.values.get("type") or next(texts, "")
    return " ".join(values) if len(values) <= _MOST_VALUES else f"{len(values)} values"


_NAMING = frozenset({"name", "reference"})
_MOST_VALUES = 4
