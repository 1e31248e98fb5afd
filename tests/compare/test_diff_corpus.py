"""`diff` finds each known change of a robot and nothing else, and no change where only the writing differs."""

from __future__ import annotations

import copy
import random
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from corpus import CORPUS, own_roots, roots
from sampling import WHOLE

from urdfctl.compare.changes import RobotChange, changes
from urdfctl.compare.snapshot import snapshot_of
from urdfctl.compare.tree import TreeNode
from urdfctl.config.settings import Settings
from urdfctl.expand.xml_writer import write
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target

ROBOTS = 100 if WHOLE else 6
XACRO = "http://www.ros.org/wiki/xacro"
Expected = list[tuple[str, str, str]]
"""The area, the kind and a pattern for the path of each change."""
Mutation = Callable[[ET.Element, random.Random], Expected]


def expanded_robots() -> list[tuple[str, str]]:
    """Some robots of the corpus with distinct names of links and joints, expanded."""
    chance = random.Random(19)  # noqa: S311 (a sample)
    of_corpus = [root for root in roots() if root["expands"] and root["counts"]["joints"] > 2]
    found = []
    own = [root for root in own_roots() if root["expands"] and root["counts"]["joints"] > 2]
    for root in (*chance.sample(own, 3), *chance.sample(of_corpus, len(of_corpus))):
        path = str(CORPUS / root["path"])
        arguments = {name: str(value) for name, value in (root.get("args") or {}).items()}
        document = Loader(Settings()).expander(path).expand(path, arguments).document
        text = write(document, path) if document is not None and document.documentElement is not None else ""
        if text and "\ue000" not in text and is_plain(ET.fromstring(text)):
            found.append((root["path"], text))
        if len(found) == ROBOTS:
            break
    return found


def is_plain(robot: ET.Element) -> bool:
    names = [(child.tag, child.get("name")) for child in robot if child.tag in ("link", "joint")]
    return len(names) == len(set(names)) and len(names) > 5


def snapshot(folder: Path, text: str, name: str = "robot.urdf") -> TreeNode:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    node = snapshot_of(Loader(Settings()).load(Target(str(path))), [str(folder)])
    assert node is not None
    return node


# -- changes -----------------------------------------------------------------------------------------------------------


def some(chance: random.Random, elements: list[ET.Element]) -> ET.Element:
    if not elements:
        raise LookupError
    return chance.choice(elements)


def a_number(robot: ET.Element, chance: random.Random, part: str, path: str, names: list[str]) -> tuple[str, str]:
    """Change one number of a part, and return the name of the part and of the attribute."""
    have = [
        e
        for e in robot.iter(part)
        if e in list(robot) and e.find(path) is not None and set(names) & {*e.find(path).attrib}
    ]  # type: ignore[union-attr]
    element = some(chance, have)
    inner = element.find(path)
    assert inner is not None
    name = chance.choice([one for one in names if one in inner.attrib])
    words = inner.attrib[name].split()
    words[0] = repr(float(words[0]) * 1.5 + 0.25)
    inner.set(name, " ".join(words))
    return str(element.get("name")), name


def limit(robot: ET.Element, chance: random.Random) -> Expected:
    name, attribute = a_number(robot, chance, "joint", "limit", ["lower", "upper", "effort", "velocity"])
    return [("limits", "changed", f"joint:{name}/limit/@{attribute}")]


def mass(robot: ET.Element, chance: random.Random) -> Expected:
    name, _ = a_number(robot, chance, "link", "inertial/mass", ["value"])
    return [("inertials", "changed", f"link:{name}/inertial/mass/@value")]


def inertia(robot: ET.Element, chance: random.Random) -> Expected:
    name, attribute = a_number(robot, chance, "link", "inertial/inertia", ["ixx", "iyz"])
    return [("inertials", "changed", f"link:{name}/inertial/inertia/@{attribute}")]


def origin(robot: ET.Element, chance: random.Random) -> Expected:
    name, attribute = a_number(robot, chance, "joint", "origin", ["xyz", "rpy"])
    return [("joints", "changed", f"joint:{name}/origin/@{attribute}")]


def kind_of_joint(robot: ET.Element, chance: random.Random) -> Expected:
    joint = some(chance, robot.findall("joint"))
    joint.set("type", "floating")
    return [("joints", "changed", f"joint:{joint.get('name')}/@type")]


def geometry(robot: ET.Element, chance: random.Random) -> Expected:
    links = [link for link in robot.findall("link") for _ in link.iterfind("visual/geometry/*")]
    link = some(chance, links)
    shape = some(chance, [*link.iterfind("visual/geometry/*")])
    name = some(chance, [ET.Element(one) for one in shape.attrib]).tag
    shape.set(name, "9.125" if name != "filename" else "other.stl")
    return [
        (
            "geometry",
            "changed",
            rf"link:{link.get('name')}/visual(:[^/]*)?(\[\d+\])?/geometry(:[^/]*)?/{shape.tag}/@{name}",
        )
    ]


def added(robot: ET.Element, chance: random.Random) -> Expected:
    parent = some(chance, robot.findall("link")).get("name")
    ET.SubElement(robot, "link", name="quite_new")
    joint = ET.SubElement(robot, "joint", name="quite_new_joint", type="prismatic")
    ET.SubElement(joint, "parent", link=str(parent))
    ET.SubElement(joint, "child", link="quite_new")
    ET.SubElement(joint, "origin", xyz="7 8 9")
    return [("links", "added", "link:quite_new"), ("joints", "added", "joint:quite_new_joint")]


def link_of(joint: ET.Element, role: str) -> str:
    return "".join(end.get("link", "") for end in joint.findall(role))


def removed(robot: ET.Element, chance: random.Random) -> Expected:
    parents = {link_of(joint, "parent") for joint in robot.findall("joint")}
    joint = some(chance, [joint for joint in robot.findall("joint") if link_of(joint, "child") not in parents])
    link = next(one for one in robot.findall("link") if one.get("name") == link_of(joint, "child"))
    robot.remove(joint)
    robot.remove(link)
    return [("links", "removed", f"link:{link.get('name')}"), ("joints", "removed", f"joint:{joint.get('name')}")]


def replace_everywhere(robot: ET.Element, old: str, new: str) -> None:
    for element in robot.iter():
        element.attrib.update({name: new for name, value in element.attrib.items() if value == old})
        element.text = new if (element.text or "").strip() == old else element.text


def names_in(robot: ET.Element, tag: str) -> list[ET.Element]:
    """The links or joints whose name nothing else has."""
    names = [child.get("name") for child in robot if child.tag in ("link", "joint", "transmission", "ros2_control")]
    return [child for child in robot.findall(tag) if names.count(child.get("name")) == 1]


def renamed_joint(robot: ET.Element, chance: random.Random) -> Expected:
    replace_everywhere(robot, str(some(chance, names_in(robot, "joint")).get("name")), "quite_other_joint")
    return [("joints", "renamed", "joint:quite_other_joint")]


def renamed_link(robot: ET.Element, chance: random.Random) -> Expected:
    replace_everywhere(robot, str(some(chance, names_in(robot, "link")).get("name")), "quite_other_link")
    return [("links", "renamed", "link:quite_other_link")]


def moved(robot: ET.Element, chance: random.Random) -> Expected:
    joint = some(chance, robot.findall("joint"))
    ends = (link_of(joint, "parent"), link_of(joint, "child"))
    other = some(chance, [link for link in robot.findall("link") if link.get("name") not in ends])
    joint.findall("parent")[0].set("link", str(other.get("name")))
    return [("joints", "moved", f"joint:{joint.get('name')}/parent/@link")]


def interface(robot: ET.Element, chance: random.Random) -> Expected:
    places = [(control, joint) for control in robot.findall("ros2_control") for joint in control.findall("joint")]
    places = [place for place in places if len(place[1].findall("command_interface")) == 1]
    if not places:
        raise LookupError
    control, joint = chance.choice(places)
    command = joint.findall("command_interface")[0]
    joint.remove(command)
    path = f"ros2_control:{control.get('name')}/joint:{joint.get('name')}/command_interface:{command.get('name')}"
    return [("interfaces", "removed", re.escape(path))]


def hardware(robot: ET.Element, chance: random.Random) -> Expected:
    control = some(chance, [one for one in robot.findall("ros2_control") if one.find("hardware/plugin") is not None])
    plugin = control.find("hardware/plugin")
    assert plugin is not None
    plugin.text = "other_hardware/System"
    return [("hardware", "changed", f"ros2_control:{control.get('name')}/hardware/plugin")]


def transmission(robot: ET.Element, chance: random.Random) -> Expected:
    found = some(chance, [one for one in robot.findall("transmission") if one.find("type") is not None])
    robot.remove(found)
    return [("transmissions", "removed", f"transmission:{found.get('name')}")]


def plugin(robot: ET.Element, chance: random.Random) -> Expected:
    found = some(chance, robot.findall("gazebo/plugin"))
    found.set("filename", "libother.so")
    return [("plugins", "changed", r"gazebo/plugin.*/@filename")]


MUTATIONS: list[Mutation] = [
    limit, mass, inertia, origin, kind_of_joint, geometry, added, removed, renamed_joint, renamed_link, moved,
    interface, hardware, transmission, plugin,
]  # fmt: skip


def wrong(found: list[RobotChange], expected: Expected) -> Iterator[str]:
    rest = list(found)
    for area, kind, path in expected:
        same = [c for c in rest if (c.area, c.kind) == (area, kind) and re.fullmatch(path, c.address)]
        if same:
            rest.remove(same[0])
        else:
            yield f"missed {kind} {path} in {area}"
    yield from (f"reported {change}" for change in rest)


def test_each_known_change_of_a_robot_is_reported_and_nothing_else(tmp_path: Path) -> None:
    chance = random.Random(20)  # noqa: S311 (a sample)
    tried, failures = 0, []
    for path, text in expanded_robots():
        before = snapshot(tmp_path, text)
        for mutate in MUTATIONS:
            robot = ET.fromstring(text)
            try:
                expected = mutate(robot, chance)
            except (LookupError, ValueError):
                continue
            tried += 1
            after = snapshot(tmp_path, ET.tostring(robot, encoding="unicode"))
            failures += [f"{path}, {mutate.__name__}: {one}" for one in wrong(changes(before, after), expected)]
    assert tried > 8 * ROBOTS
    assert failures == []


# -- the same robot, written in another way ----------------------------------------------------------------------------


def in_other_order(robot: ET.Element, chance: random.Random) -> ET.Element:
    for element in robot.iter():
        children = list(element)
        chance.shuffle(children)
        element[:] = children
    return robot


def with_other_blanks(robot: ET.Element, _: random.Random) -> ET.Element:
    ET.indent(robot, "\t")
    for element in robot.iter():
        numeric = {name: v for name, v in element.attrib.items() if re.fullmatch(r"[-\d. ]+", v)}
        element.attrib.update({name: f"  {'  '.join(value.split())} " for name, value in numeric.items()})
    return robot


def in_macros(robot: ET.Element, chance: random.Random) -> ET.Element:
    """Each part in a macro of its own, with one of its numbers as a parameter."""
    ET.register_namespace("xacro", XACRO)
    written = ET.Element(robot.tag, robot.attrib)
    for number, part in enumerate(copy.deepcopy(robot)):
        for element in part.iter():
            element.attrib.update({name: re.sub(r"\$(?=[({])", "$$$$", v) for name, v in element.attrib.items()})
            element.text = re.sub(r"\$(?=[({])", "$$$$", element.text or "")
        numbers = [(e, name) for e in part.iter() for name, v in e.attrib.items() if re.fullmatch(r"-?\d+\.\d+", v)]
        macro = ET.SubElement(written, f"{{{XACRO}}}macro", name=f"part_{number}", params="value:=0")
        call: dict[str, str] = {}
        if numbers:
            element, name = chance.choice(numbers)
            call = {"value": repr(float(element.attrib[name]) / 2)}
            element.set(name, "${2 * value}")
        macro.append(part)
        ET.SubElement(written, f"{{{XACRO}}}part_{number}", call)
    return written


REWRITINGS: list[Callable[[ET.Element, random.Random], ET.Element]] = [in_other_order, with_other_blanks, in_macros]


@pytest.mark.parametrize("rewrite", REWRITINGS)
def test_a_robot_that_is_only_written_in_another_way_has_no_changes(tmp_path: Path, rewrite: Any) -> None:
    chance = random.Random(21)  # noqa: S311 (a sample)
    failures = []
    for path, text in expanded_robots():
        before = snapshot(tmp_path, text)
        other = ET.tostring(rewrite(ET.fromstring(text), chance), encoding="unicode")
        after = snapshot(tmp_path, other, "robot.xacro")
        failures += [f"{path}: {change}" for change in [*changes(before, before), *changes(before, after)]]
    assert failures == []
