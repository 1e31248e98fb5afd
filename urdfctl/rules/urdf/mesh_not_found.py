"""UC149."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.urdf.common import is_known, label, robot_in


@rule(
    "UC149",
    severity=Severity.WARNING,
    authority="resource_retriever: 'Could not load resource [...]'; urdfdom does not open meshes",
    bad={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <visual>
                <geometry><mesh filename="«package://arm_description/meshes/tol.stl»"/></geometry>
              </visual>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
        "package.xml": """
            <package format="3"><name>arm_description</name></package>
        """,
        "meshes/tool.stl": """
            solid tool
            endsolid tool
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool">
              <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
              <visual>
                <geometry><mesh filename="package://arm_description/meshes/tool.stl"/></geometry>
              </visual>
            </link>
            <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
        """,
        "package.xml": """
            <package format="3"><name>arm_description</name></package>
        """,
        "meshes/tool.stl": """
            solid tool
            endsolid tool
        """,
    },
)
def mesh_not_found(project: Project) -> Iterator[Finding]:
    """The file of a mesh does not exist.

    urdfdom does not look. RViz shows nothing there, and Gazebo leaves the shape out: the link touches nothing.
    """
    robot = robot_in(project)
    told = set()
    for mesh in robot.meshes if robot else ():
        file = mesh.file
        if (
            file is None
            or file.exists
            or not file.package_found
            or mesh.filename in told
            or not is_known(mesh.filename)
        ):
            continue
        told.add(mesh.filename)
        hint = f"; did you mean '{file.nearest}'?" if file.nearest else ""
        yield Finding(mesh.at, f"no such file: '{mesh.filename}', a mesh of {label('link', mesh.link)}{hint}")
