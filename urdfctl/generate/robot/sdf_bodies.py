"""The links and joints of a robot in SDF, as Gazebo's parser converts a URDF (sdformat, parser_urdf.cc).

What fixed joints connect is one link, with a frame for each joint and link that was merged. Poses have all digits.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.generate.robot.facts import JointFacts, Skeleton
from urdfctl.generate.robot.frames import (
    NOTHING,
    axis_of,
    bulk_of,
    frames_of,
    geometries_of,
    number_of,
    origin_of,
    outwards,
    root_of,
)
from urdfctl.generate.robot.inertia_repair import nearest_valid
from urdfctl.generate.robot.mjcf_bodies import quaternion
from urdfctl.generate.text.scalars import xml_text
from urdfctl.model.geometry import Pose, scaled
from urdfctl.model.robot import Geometry, Joint, Robot, Tag

_TYPES = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic", "fixed": "fixed"}
_ENDLESS = "1e+16"
_WORLD = "world"
_MODEL = "__model__"
_FRICTION = {"mu1": "mu", "mu2": "mu2"}


class _Writer:
    """Writes the links of one robot, and collects what is left out.

    `tops` are the links that others were merged into, by the names of these, with the poses of the others in them.
    """

    def __init__(self, robot: Robot, joints: Sequence[JointFacts]) -> None:
        self._robot, self._facts = robot, {joint.name: joint for joint in joints}
        self._links = {link.name: link for link in robot.links if link.name}
        self._root = root_of(robot) or ""
        self.notes: dict[str, None] = {}
        self.tops: dict[str, tuple[str, Pose]] = {self._root: (self._root, Pose())}
        self._kept: list[tuple[Joint, str, str]] = []
        self._merged: list[tuple[Joint, str, str]] = []
        preserved = {one.reference for one in robot.gazebos if next(one.tag.named("preserveFixedJoint"), None)}
        for joint, parent, child in outwards(robot):
            top, pose = self.tops[parent]
            if joint.type == "fixed" and top != _WORLD and joint.name not in preserved:
                self.tops[child] = (top, pose.then(_origin(joint.tag)))
                self._merged.append((joint, parent, child))
            else:
                self.tops[child] = (child, Pose())
                self._kept.append((joint, parent, child))

    def lines(self) -> Iterator[str]:
        """Yield the lines of the model: links, merged frames, and joints."""
        joint_of = {child: joint for joint, _, child in self._kept}
        frames = frames_of(self._robot)
        for name in dict.fromkeys(top for top, _ in self.tops.values()):
            if name == _WORLD and name == self._root:
                continue
            joint = joint_of.get(name)
            place = _pose(frames[name]) if joint is None or joint.type not in _TYPES else _pose(Pose(), joint.name)
            yield from self._link(name, place)
        for joint, parent, child in self._merged:
            first, *then = [joint.name or "", child] if joint.name not in self._links else [child]
            yield f'    <frame name="{xml_text(first)}" attached_to="{xml_text(parent)}">'
            yield f"      {_pose(_origin(joint.tag))}"
            yield "    </frame>"
            yield from (f'    <frame name="{xml_text(name)}" attached_to="{xml_text(first)}"/>' for name in then)
        for joint, parent, child in self._kept:
            yield from self._joint(joint, parent, child)
        for gazebo in self._robot.gazebos:
            for tag in gazebo.tag.children if not gazebo.reference else ():
                yield from _markup(tag, "    ")

    def _link(self, top: str, place: str) -> Iterator[str]:
        members = [(name, pose) for name, (its_top, pose) in self.tops.items() if its_top == top]
        yield f'    <link name="{xml_text(top)}">'
        yield f"      {place}"
        yield from self._inertial(top, members)
        for name, pose in members:
            named = name if name == top else f"{top}_fixed_joint_lump__{name}"
            numbers = {"visual": 0, "collision": 0}
            for geometry, tag in geometries_of(self._links.get(name)):
                shape = _shape(geometry)
                if shape is None:
                    continue
                number, numbers[geometry.role] = numbers[geometry.role], numbers[geometry.role] + 1
                full = f"{named}_{geometry.role}{f'_{number}' if number else ''}"
                yield f'      <{geometry.role} name="{xml_text(full)}">'
                yield f"        {_pose(pose.then(_origin(tag)))}"
                yield f"        <geometry>{shape}</geometry>"
                yield from self._surface(name) if geometry.role == "collision" else ()
                yield f"      </{geometry.role}>"
            yield from self._of_gazebo(name, pose)
        yield "    </link>"

    def _inertial(self, top: str, members: Sequence[tuple[str, Pose]]) -> Iterator[str]:
        bulk = NOTHING
        for name, pose in members:
            bulk = bulk.plus(bulk_of(self._links.get(name), pose))
        if bulk.mass <= 0:
            self.notes[f"link '{top}' has no mass: Gazebo drops it, and what hangs on it"] = None
            return
        centre = scaled(bulk.moment, 1 / bulk.mass)
        x, y, z = centre
        steiner = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
        full = [
            [a - bulk.mass * b for a, b in zip(row, other, strict=True)]
            for row, other in zip(bulk.inertia, steiner, strict=True)
        ]
        given = [full[0][0], full[0][1], full[0][2], full[1][1], full[1][2], full[2][2]]
        valid = nearest_valid(given, bulk.mass, 0.0)
        if valid is not None:
            self.notes[f"the inertia of link '{top}' is impossible for a solid; the nearest possible one is taken"] = (
                None
            )
        names = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        values = "".join(f"<{name}>{value!r}</{name}>" for name, value in zip(names, valid or given, strict=True))
        yield f"      <inertial>{_pose(Pose(centre))}<mass>{bulk.mass!r}</mass><inertia>{values}</inertia></inertial>"

    def _joint(self, joint: Joint, parent: str, child: str) -> Iterator[str]:
        name, kind = joint.name or "", _TYPES.get(joint.type or "")
        if kind is None:
            self.notes[
                f"joint '{name}' is left out: Gazebo converts no '{joint.type}' joint; link '{child}' is free"
            ] = None
            return
        top, pose = self.tops[parent]
        frame = _MODEL if top == _WORLD == self._root else top  # 'world' is no frame in a model
        yield f'    <joint name="{xml_text(name)}" type="{kind}">'
        yield f"      {_pose(pose.then(_origin(joint.tag)), frame)}"
        yield f"      <parent>{xml_text(top)}</parent><child>{xml_text(child)}</child>"
        if kind != "fixed":
            yield f"      {self._axis(joint)}"
        yield "    </joint>"

    def _axis(self, joint: Joint) -> str:
        facts = self._facts.get(joint.name or "") or JointFacts(joint.name or "")
        lower, upper = (f"-{_ENDLESS}", _ENDLESS)
        if joint.type != "continuous":
            lower, upper = (repr(float(end)) if end is not None else "0.0" for end in (facts.lower, facts.upper))
        limit = f"<lower>{lower}</lower><upper>{upper}</upper>"
        limit += f"<effort>{float(facts.effort)!r}</effort>" if facts.effort else ""
        limit += f"<velocity>{float(facts.velocity)!r}</velocity>" if facts.velocity else ""
        dynamics = f"<damping>{facts.damping!r}</damping><friction>{facts.friction!r}</friction>"
        mimic = ""
        if facts.mimic:
            leader, factor, offset = facts.mimic
            rest = f"<multiplier>{factor!r}</multiplier><offset>{offset!r}</offset><reference>0</reference>"
            mimic = f'<mimic joint="{xml_text(leader)}">{rest}</mimic>'
        x, y, z = axis_of(joint, Pose())
        xyz = f"<xyz>{x!r} {y!r} {z!r}</xyz>"
        return f"<axis>{xyz}{mimic}<limit>{limit}</limit><dynamics>{dynamics}</dynamics></axis>"

    def _surface(self, link: str) -> Iterator[str]:
        """The friction that `<gazebo>` gives a link."""
        tags = [tag for one in self._robot.gazebos if one.reference == link for tag in one.tag.children]
        values = {_FRICTION[tag.name]: tag.text.strip() for tag in tags if tag.name in _FRICTION}
        known = "".join(f"<{name}>{text}</{name}>" for name, text in values.items() if number_of(text) is not None)
        if known:
            yield f"        <surface><friction><ode>{known}</ode></friction></surface>"

    def _of_gazebo(self, link: str, pose: Pose) -> Iterator[str]:
        """The sensors and plugins that `<gazebo>` gives a link, and whether it falls."""
        for tag in (tag for one in self._robot.gazebos if one.reference == link for tag in one.tag.children):
            if tag.name == "turnGravityOff" and tag.text.strip() in ("true", "1"):
                yield "      <gravity>false</gravity>"
            elif tag.name in ("sensor", "plugin"):
                has_pose = next(tag.named("pose"), None) is not None
                yield from _markup(tag, "      ", _pose(pose) if tag.name == "sensor" and not has_pose else "")


def sdf_of(robot: Robot, joints: Sequence[JointFacts]) -> Skeleton:
    """Return a robot's links and joints in SDF, with what is left out."""
    writer = _Writer(robot, joints)
    lines = "\n".join(writer.lines())
    return Skeleton(lines, lines, (), tuple(writer.notes))


def _origin(tag: Tag) -> Pose:
    return origin_of(next(tag.named("origin"), None))


def _pose(pose: Pose, frame: str | None = None) -> str:
    w, x, y, z = quaternion(pose.turn)
    to = f' relative_to="{xml_text(frame)}"' if frame else ""
    numbers = " ".join(repr(float(value)) for value in (*pose.place, x, y, z, w))
    return f'<pose{to} rotation_format="quat_xyzw">{numbers}</pose>'


def _shape(geometry: Geometry) -> str | None:
    shape = geometry.shape
    if shape is None:
        return None
    if shape.name == "mesh":
        address = shape.attributes.get("filename", "").replace("package://", "model://")
        scale = xml_text(shape.attributes.get("scale", "1 1 1"))
        return f"<mesh><uri>{xml_text(address)}</uri><scale>{scale}</scale></mesh>"
    names = {"box": ("size",), "cylinder": ("radius", "length"), "capsule": ("radius", "length"), "sphere": ("radius",)}
    values = "".join(
        f"<{name}>{xml_text(shape.attributes.get(name, ''))}</{name}>" for name in names.get(shape.name, ())
    )
    return f"<{shape.name}>{values}</{shape.name}>" if values else None


def _markup(tag: Tag, indent: str, first: str = "") -> Iterator[str]:
    """The lines of an element as it is written; first: what is put before its content."""
    attributes = "".join(f' {name}="{xml_text(text)}"' for name, text in tag.attributes.items())
    if not tag.children and not first:
        yield f"{indent}<{tag.name}{attributes}>{xml_text(tag.text.strip())}</{tag.name}>"
        return
    yield f"{indent}<{tag.name}{attributes}>"
    if first:
        yield f"{indent}  {first}"
    for child in tag.children:
        yield from _markup(child, f"{indent}  ")
    yield f"{indent}</{tag.name}>"
