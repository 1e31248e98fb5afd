"""Robots and what belongs to them that grow by one part: each takes how many parts, and gives the files of a folder."""

from __future__ import annotations

from collections.abc import Callable

Tree = dict[str, str]
ROBOT, LAUNCH, CONTROLLERS = "urdf/r.xacro", "launch/r.launch.py", "config/c.yaml"
MANIFEST = """<package format="3"><name>p</name><version>1.0.0</version><description>d</description>
<maintainer email="a@b.c">m</maintainer><license>MIT</license>{}</package>
"""
ROS1_LAUNCH, XML_LAUNCH, YAML_LAUNCH = "launch/r.launch", "launch/r.launch.xml", "launch/r.launch.yaml"
LIMIT = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'


def robot(content: str, name: str = ROBOT) -> Tree:
    root = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
    return {"package.xml": MANIFEST.format(""), name: f'{root}<link name="base"/>\n{content}\n</robot>\n'}


def joint(name: str, child: str, parent: str = "base", kind: str = "revolute", inside: str = LIMIT) -> str:
    links = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{links}{inside}</joint>\n'


def star(count: int) -> str:
    return "".join(f'<link name="l{i}"/>\n{joint(f"j{i}", f"l{i}")}' for i in range(count))


def chain(count: int) -> str:
    return "".join(
        f'<link name="l{i}"/>\n{joint(f"j{i}", f"l{i}", f"l{i - 1}" if i else "base")}' for i in range(count)
    )


def component(joints: str, name: str = "c") -> str:
    plugin = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    return f'<ros2_control name="{name}" type="system">{plugin}\n{joints}</ros2_control>\n'


def controlled(name: str) -> str:
    command, state = '<command_interface name="position"/>', '<state_interface name="position"/>'
    return f'<joint name="{name}">{command}{state}</joint>\n'


def transmission(index: int, of: str) -> str:
    interface = "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>"
    actuator = f'<actuator name="a{index}"><mechanicalReduction>1</mechanicalReduction></actuator>'
    kind = "<type>transmission_interface/SimpleTransmission</type>"
    return f'<transmission name="t{index}">{kind}<joint name="{of}">{interface}</joint>{actuator}</transmission>\n'


def manager(names: list[str], rest: str) -> str:
    known = "".join(f"    {name}: {{type: position_controllers/JointGroupPositionController}}\n" for name in names)
    return f"controller_manager:\n  ros__parameters:\n    update_rate: 100\n{known}{rest}"


def group(name: str, joints: str) -> str:
    return f"{name}:\n  ros__parameters:\n    joints: [{joints}]\n    interface_name: position\n"


def with_controllers(content: str, yaml: str) -> Tree:
    return {**robot(content), CONTROLLERS: yaml}


def described(count: int, joint_count: int = 0) -> Tree:
    return robot(star(joint_count or count) + component("".join(controlled(f"j{i}") for i in range(count))))


Grown = Callable[[int], Tree]
ROBOTS: dict[str, Grown] = {
    # URDF
    "links on the base": lambda n: robot(star(n)),
    "links in a chain": lambda n: robot(chain(n)),
    "links on one line": lambda n: robot(star(n).replace("\n", "")),
    "links on one line that is not ASCII": lambda n: robot("é" + star(n).replace("\n", "")),
    "links of one name": lambda n: robot('<link name="l"/>\n' * n),
    "joints of one name": lambda n: robot('<link name="l"/>' + joint("j", "l") * n),
    "joints with unknown links": lambda n: robot("".join(joint(f"j{i}", f"lnk_{i}_a") for i in range(n))),
    "joints with links of similar names": lambda n: robot(
        "".join(f'<link name="link_{i}_a"/>{joint(f"j{i}", f"link_{i}_b")}' for i in range(n))
    ),
    "joints without limits": lambda n: robot(
        "".join(f'<link name="l{i}"/>\n{joint(f"j{i}", f"l{i}", inside="")}' for i in range(n))
    ),
    "joints that mimic the last": lambda n: robot(
        "".join(
            f'<link name="l{i}"/>' + joint(f"j{i}", f"l{i}", inside=f'{LIMIT}<mimic joint="j{max(i - 1, 0)}"/>')
            for i in range(n)
        )
    ),
    "loops of links": lambda n: robot("".join(joint(f"j{i}", f"l{(i + 1) % n}", f"l{i}") for i in range(n))),
    "inertias": lambda n: robot(
        "".join(
            f'<link name="l{i}"><inertial><mass value="1"/>{INERTIA}</inertial></link>{joint(f"j{i}", f"l{i}")}'
            for i in range(n)
        )
    ),
    "numbers that are none": lambda n: robot(
        "".join(f'<link name="l{i}"/>\n{joint(f"j{i}", f"l{i}").replace("effort=", "effort=0x")}' for i in range(n))
    ),
    "missing meshes": lambda n: robot(
        "".join(
            f'<link name="l{i}"><visual><geometry><mesh filename="package://p/m/a{i}.stl"/></geometry></visual></link>\n'
            for i in range(n)
        )
    ),
    "meshes of unknown packages": lambda n: robot(
        "".join(
            f'<link name="l{i}"><visual><geometry><mesh filename="package://q{i}/a.stl"/></geometry></visual></link>\n'
            for i in range(n)
        )
    ),
    "unknown materials": lambda n: robot(
        "".join(
            f'<material name="red_{i}_a"/><link name="l{i}"><visual><geometry><sphere radius="1"/></geometry>'
            f'<material name="red_{i}_b"/></visual></link>\n'
            for i in range(n)
        )
    ),
    "collisions of one link": lambda n: robot(
        '<link name="l">' + '<collision><geometry><sphere radius="1"/></geometry></collision>\n' * n + "</link>"
    ),
    "Gazebo's elements of unknown links": lambda n: robot(
        star(n // 4) + "".join(f'<gazebo reference="l_{i}"><mu1>1</mu1></gazebo>\n' for i in range(n))
    ),
    "Gazebo's elements of one link": lambda n: robot('<gazebo reference="base"><mu1>1</mu1></gazebo>\n' * n),
    "Gazebo's plugins": lambda n: robot(
        "".join(f'<gazebo><plugin name="g{i}" filename="libgazebo_ros_control.so"/></gazebo>\n' for i in range(n))
    ),
    "sensors": lambda n: robot(
        "".join(
            f'<gazebo reference="base"><sensor name="s{i}" type="camera"><plugin name="g{i}" '
            f'filename="libgazebo_ros_camera.so"/></sensor></gazebo>\n'
            for i in range(n)
        )
    ),
    "elements in elements": lambda n: robot("<a>" * n + "</a>" * n),
    "attributes of one element": lambda n: robot("<a " + " ".join(f'b{i}="1"' for i in range(n)) + "/>"),
    "elements that nobody knows": lambda n: robot("".join(f"<lnk{i}/>\n" for i in range(n))),
    "comments": lambda n: robot("<!-- a -->\n" * n),
    "suppressions": lambda n: robot("<!-- urdfctl: ignore[UC201] x -->\n" * n),
    "suppressions with findings": lambda n: robot('<link name="b"/><!-- urdfctl: ignore[UC1] -->\n' * n),
    "suppressions on one line": lambda n: robot('<link name="b"/><!-- urdfctl: ignore[UC1] -->' * n),
    "suppressions in conditions": lambda n: robot(
        '<xacro:if value="1"><!-- urdfctl: ignore[UC1] --><a/>\n</xacro:if>' * n
    ),
    "codes of a suppression": lambda n: robot(
        f"<!-- urdfctl: ignore[{', '.join(f'UC{i}' for i in range(n))}] -->" + '<link name="b"/>' * n
    ),
    # control
    "transmissions": lambda n: robot(star(n) + "".join(transmission(i, f"j{i}") for i in range(n))),
    "transmissions of one joint": lambda n: robot(star(1) + "".join(transmission(i, "j0") for i in range(n))),
    "transmissions of one name": lambda n: robot(star(1) + transmission(0, "j0") * n),
    "transmissions of unknown joints": lambda n: robot(
        star(n // 4) + "".join(transmission(i, f"j_{i}") for i in range(n))
    ),
    "joints of a component": described,
    "unknown joints of a component": lambda n: robot(
        star(n // 4) + component("".join(controlled(f"j_{i}") for i in range(n)))
    ),
    "one joint of a component": lambda n: robot(star(1) + component(controlled("j0") * n)),
    "components": lambda n: robot(star(n) + "".join(component(controlled(f"j{i}"), f"c{i}") for i in range(n))),
    "components of one name": lambda n: robot(star(1) + component(controlled("j0")) * n),
    "parameters of a component": lambda n: robot(
        component("").replace(
            "</hardware>", "".join(f'<param name="p{i}">1</param>\n' for i in range(n)) + "</hardware>"
        )
    ),
    "interfaces of a joint": lambda n: robot(
        star(1)
        + component(
            '<joint name="j0">' + "".join(f'<command_interface name="position{i}"/>\n' for i in range(n)) + "</joint>"
        )
    ),
    # xacro
    "macros": lambda n: robot(
        "".join(f'<xacro:macro name="m{i}" params="a"><a b="${{a}}"/></xacro:macro>\n' for i in range(n))
        + "".join(f'<xacro:m{i} a="1"/>\n' for i in range(n))
    ),
    "macros that are not called": lambda n: robot(
        "".join(f'<xacro:macro name="m{i}" params="a"><a b="${{a}}"/></xacro:macro>\n' for i in range(n))
    ),
    "macros of one name": lambda n: robot('<xacro:macro name="m"><a/></xacro:macro>\n' * n),
    "unknown macros": lambda n: robot(
        "".join(f'<xacro:macro name="wheel_{i}_a"><a/></xacro:macro><xacro:wheel_{i}_b/>\n' for i in range(n))
    ),
    "calls of a macro": lambda n: robot(
        '<xacro:macro name="m" params="a"><link name="l${a}"/></xacro:macro>\n'
        + "".join(f'<xacro:m a="{i}"/>\n' for i in range(n))
    ),
    "parameters of a macro": lambda n: robot(
        '<xacro:macro name="m" params="' + " ".join(f"a{i}:=1" for i in range(n)) + '"><a/></xacro:macro><xacro:m/>'
    ),
    "blocks of a macro": lambda n: robot(
        '<xacro:macro name="m" params="'
        + " ".join(f"*a{i}" for i in range(n))
        + '">'
        + "".join(f'<xacro:insert_block name="a{i}"/>' for i in range(n))
        + f"</xacro:macro><xacro:m>{'<a/>' * n}</xacro:m>"
    ),
    "properties": lambda n: robot("".join(f'<xacro:property name="p{i}" value="{i}"/>\n' for i in range(n))),
    "properties of properties": lambda n: robot(
        '<xacro:property name="p0" value="1"/>\n'
        + "".join(f'<xacro:property name="p{i}" value="${{p{i - 1} + 1}}"/><a b="${{p{i}}}"/>\n' for i in range(1, n))
    ),
    "properties of later properties": lambda n: robot(
        "".join(f'<xacro:property name="p{i}" value="${{p{i + 1} + 1}}"/>\n' for i in range(n))
        + f'<xacro:property name="p{n}" value="1"/><a b="${{p0}}"/>'
    ),
    "unknown names": lambda n: robot(
        "".join(f'<xacro:property name="size_{i}_a" value="1"/><a b="${{size_{i}_b}}"/>\n' for i in range(n))
    ),
    "expressions": lambda n: robot("".join(f'<a b="${{{i} * 2 + 1}}"/>\n' for i in range(n))),
    "expressions of one text": lambda n: robot("<a>" + "${1 + 1} " * n + "</a>"),
    "a long expression": lambda n: robot('<a b="${' + "1+" * n + '1}"/>'),
    "arguments": lambda n: robot(
        "".join(f'<xacro:arg name="a{i}" default="1"/><a b="$(arg a{i})"/>\n' for i in range(n))
    ),
    "unused arguments": lambda n: robot("".join(f'<xacro:arg name="a{i}" default="1"/>\n' for i in range(n))),
    "unknown arguments": lambda n: robot(
        "".join(f'<xacro:arg name="size_{i}_a" default="1"/><a b="$(arg size_{i}_b)"/>\n' for i in range(n))
    ),
    "conditions": lambda n: robot('<xacro:if value="${1 == 1}"><a/></xacro:if>\n' * n),
    "false conditions": lambda n: robot('<xacro:unless value="${1 == 1}"><link name="a"/></xacro:unless>\n' * n),
    "conditions in conditions": lambda n: robot('<xacro:if value="1">' * n + "</xacro:if>" * n),
    "evaluations": lambda n: robot('<a b="$(eval 1 + 1)"/>\n' * n),
    "unknown packages": lambda n: robot("".join(f'<a b="$(find pkg_{i})"/>\n' for i in range(n))),
    "includes of one file": lambda n: {
        **robot('<xacro:include filename="a.xacro"/>\n' * n),
        "urdf/a.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><a/></robot>',
    },
    "includes of missing files": lambda n: robot(
        "".join(f'<xacro:include filename="a{i}.xacro"/>\n' for i in range(n))
    ),
    "values of YAML": lambda n: {
        **robot(
            '<xacro:property name="c" value="${xacro.load_yaml(\'c.yaml\')}"/>\n'
            + "".join(f"<a b=\"${{c['a{i}']}}\"/>\n" for i in range(n))
        ),
        "urdf/c.yaml": "".join(f"a{i}: 1\n" for i in range(n)),
    },
    # controllers
    "controllers": lambda n: with_controllers(
        star(n) + component("".join(controlled(f"j{i}") for i in range(n))),
        manager([f"c{i}" for i in range(n)], "".join(group(f"c{i}", f"j{i}") for i in range(n))),
    ),
    "controllers of one joint": lambda n: with_controllers(
        star(1) + component(controlled("j0")),
        manager([f"c{i}" for i in range(n)], "".join(group(f"c{i}", "j0") for i in range(n))),
    ),
    "joints of a controller": lambda n: with_controllers(
        star(n) + component("".join(controlled(f"j{i}") for i in range(n))),
        manager(["c"], group("c", ", ".join(f"j{i}" for i in range(n)))),
    ),
    "unknown joints of a controller": lambda n: with_controllers(
        star(n // 4) + component("".join(controlled(f"j{i}") for i in range(n // 4))),
        manager(["c"], group("c", ", ".join(f"j_{i}" for i in range(n)))),
    ),
    "one joint of a controller": lambda n: with_controllers(
        star(1) + component(controlled("j0")), manager(["c"], group("c", ", ".join(["j0"] * n)))
    ),
    "unknown parameters of a controller": lambda n: with_controllers(
        star(1), manager(["c"], group("c", "j0") + "".join(f"    joint_{i}: 1\n" for i in range(n)))
    ),
    "controllers of unknown types": lambda n: with_controllers(
        star(1),
        "controller_manager:\n  ros__parameters:\n"
        + "".join(f"    c{i}: {{type: position_controllers/JointGroupPosition{i}}}\n" for i in range(n)),
    ),
    "controllers without a type": lambda n: with_controllers(
        star(1), manager([], "".join(group(f"c{i}", "j0") for i in range(n)))
    ),
    "gains": lambda n: with_controllers(
        star(n) + component("".join(controlled(f"j{i}") for i in range(n))),
        "controller_manager:\n  ros__parameters:\n"
        "    c: {type: joint_trajectory_controller/JointTrajectoryController}\n"
        f"c:\n  ros__parameters:\n    joints: [{', '.join(f'j{i}' for i in range(n))}]\n"
        "    command_interfaces: [effort]\n    state_interfaces: [position, velocity]\n    gains:\n"
        + "".join(f"      j{i}: {{p: 1.0, i: 0.0, d: 0.0}}\n" for i in range(n)),
    ),
    "controllers of ROS 1": lambda n: with_controllers(
        star(n) + "".join(transmission(i, f"j{i}") for i in range(n)),
        "".join(f"c{i}:\n  type: effort_controllers/JointEffortController\n  joint: j{i}\n" for i in range(n)),
    ),
    "keys of one name": lambda n: with_controllers(star(1), "a: 1\n" * n),
    "anchors": lambda n: with_controllers(
        star(1), "controller_manager:\n  ros__parameters: {}\n" + "".join(f"a{i}: &a{i} 1\n" for i in range(n))
    ),
    "aliases": lambda n: with_controllers(
        star(1), "controller_manager:\n  ros__parameters: &a {b: 1}\n" + "".join(f"a{i}: *a\n" for i in range(n))
    ),
    "documents": lambda n: with_controllers(star(1), "---\na: 1\n" * n),
    "tags": lambda n: with_controllers(star(1), "".join(f"a{i}: !!python/tuple [1]\n" for i in range(n))),
    "a list of YAML": lambda n: with_controllers(star(1), f"a: [{', '.join(['1'] * n)}]"),
    "lists in lists": lambda n: with_controllers(star(1), "a: " + "[" * n + "]" * n),
    "parameters of nodes": lambda n: with_controllers(
        star(1), manager([], "".join(f"node{i}:\n  ros__parameters: {{a: 1}}\n" for i in range(n)))
    ),
}
