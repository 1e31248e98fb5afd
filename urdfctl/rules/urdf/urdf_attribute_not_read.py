"""UC163."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.grammar import ATTRIBUTES, read_tags

_OF_OTHERS = {
    "link": ("type", "concave"),
    "joint": ("dont_collapse",),
    "dynamics": ("D", "K", "mu_coulomb", "mu_viscous"),
    "limit": ("acceleration", "deceleration", "jerk"),
    "origin": ("quat_xyzw",),
    "mesh": ("name",),
    "material": ("type",),
    "inertia": ("iyx", "izx", "izy"),
}
"""Attributes that other or newer readers take, or that many robots have without harm: Bullet, urdfdom 5, Franka."""
_NAMING = ("parent", "child", "mimic")
"""Elements whose first attribute names another part; a rule tells if that is missing."""
_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
      %s
    </link>
    <joint name="wrist" type="revolute">
      <parent link="fore"/><child link="tool"/>%s
    </joint>
"""
_LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"%s/>'
_VISUAL = "<visual>%s<geometry>%s</geometry></visual>"


@rule(
    "UC163",
    severity=Severity.WARNING,
    runtime="ignores",
    authority='urdfdom urdf_parser: Attribute("...") by exact name; unknown attributes are silently ignored',
    bad=[
        {"robot.urdf": _WRIST % ("", _LIMIT % ' damping="«0.1»" max="«3»"')},
        {
            "robot.urdf": _WRIST
            % (
                _VISUAL % ('<origin xyz="0 0 0" quaternion="«0 0 0 1»"/>', '<sphere radius="1" diameter="«2»"/>')
                + _VISUAL % ("", '<cylinder radius="1" length="1" height="«2»"/>'),
                _LIMIT % "" + '<dynamics damping="1" stiffness="«3»"/>',
            )
        },
    ],
    good=[
        {
            "robot.urdf": _WRIST.replace('name="tool"', 'name="tool" type="gripper" concave="yes"', 1)
            .replace('name="wrist"', 'name="wrist" dont_collapse="true"')
            .replace('ixy="0"', 'ixy="0" iyx="0" izx="0" izy="0"')
            % (
                _VISUAL % ('<origin xyz="0 0 0" quat_xyzw="0 0 0 1"/>', '<sphere radius="1"/>')
                + _VISUAL % ("", '<mesh filename="package://arm/tool.stl" name="tool"/>')
                + '<visual><geometry><box size="1 1 1"/></geometry><material name="g" type="x"><color rgba="1 1 1 1"/></material></visual>',
                _LIMIT % ' acceleration="1" deceleration="1" jerk="1"'
                + '<dynamics damping="1" D="1" K="7000" mu_coulomb="0" mu_viscous="16"/>',
            ),
            "package.xml": "<package><name>arm</name></package>",
            "tool.stl": "solid tool\nendsolid tool\n",
        },
    ],
)
def urdf_attribute_not_read(project: Project) -> Iterator[Finding]:
    """Attribute that nothing reads.

    urdfdom reads the attributes of each element by their names, and silently ignores all others: the value has no
    effect. Often it belongs to another element, as damping into <dynamics>. If the attribute moves nothing, as
    `rpy="0 0 0"` in an <axis>, or is a limit that is 0 anyway, it is only worth knowing.
    """
    robot = robot_in(project)
    for tag, _, owner in read_tags(robot) if robot else ():
        known = ATTRIBUTES.get(tag.name, ())
        taken = (*known, *_OF_OTHERS.get(tag.name, ()))
        is_judged = known and not (tag.name in _NAMING and known[0] not in tag.attributes)
        for name in tag.attributes if is_judged else ():
            if name in taken or ":" in name or name.startswith("xmlns") or _is_slip(name, known, tag.attributes):
                continue
            other = next((element for element, names in ATTRIBUTES.items() if name in names and len(name) > 4), None)  # noqa: PLR2004
            hint = f"; <{other}> has one of that name" if other else ""
            of = owner if tag.name in ("link", "joint") else f"<{tag.name}> of {owner}"
            severity = Severity.INFO if _is_neutral(name, tag.attributes[name]) else None
            yield Finding(tag.at[name], f"attribute '{name}' of {of} is ignored{hint}", severity=severity)


def _is_neutral(name: str, text: str) -> bool:
    """Whether nothing is lost: all numbers are 0 of a pose, or of a limit that is 0 by itself.

    An exporter of SolidWorks writes soft_upper_limit and soft_lower_limit, which are 0 by default, without `_limit`.
    """
    is_soft_limit = name.startswith("soft_") and f"{name}_limit" in ATTRIBUTES["safety_controller"]
    is_neutral = is_soft_limit or name in ATTRIBUTES["origin"]
    return is_neutral and not any(word.strip("+-.0") for word in text.split())


def _is_slip(name: str, known: tuple[str, ...], given: object) -> bool:
    """Whether it is a misspelt attribute, which another rule reports."""
    lacking = [other for other in known if other not in given]  # type: ignore[operator]
    return bool(any(sorted(other) == sorted(name.lower()) for other in lacking) or nearest(name, lacking))
