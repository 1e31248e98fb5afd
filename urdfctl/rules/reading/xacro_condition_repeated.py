"""UC022."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.reading.common import findings_of
from urdfctl.source.problem import ProblemKind


@rule(
    "UC022",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="xacro/__init__.py eval_all(): each <xacro:if> is decided by itself",
    bad=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="is_round" value="true"/>
                  <link name="base">
                    <visual>
                      <geometry>
                        <xacro:if value="${is_round}"><sphere radius="1"/></xacro:if>
                        «<xacro:if value="${is_round}">»<sphere radius="2"/></xacro:if>
                      </geometry>
                    </visual>
                  </link>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="is_round" value="true"/>
                  <link name="base">
                    <visual>
                      <geometry>
                        <xacro:if value="${is_round}"><sphere radius="1"/></xacro:if>
                        <xacro:unless value="${is_round}"><sphere radius="2"/></xacro:unless>
                      </geometry>
                    </visual>
                  </link>
                </robot>
            """,
        },
        {
            "robot.xacro": """
                <robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
                  <xacro:property name="sim" value="true"/>
                  <link name="base"/>
                  <xacro:if value="${sim}">
                    <gazebo><plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/></gazebo>
                  </xacro:if>
                  <xacro:if value="${sim}">
                    <gazebo><plugin filename="gz-sim-contact-system" name="gz::sim::systems::Contact"/></gazebo>
                  </xacro:if>
                </robot>
            """,
        },
    ],
)
def xacro_condition_repeated(project: Project) -> Iterator[Finding]:
    """Same condition on two alternatives.

    Two `<xacro:if>` in a row have the same condition and contain the same elements, of the same names if they have any.
    The robot gets both or neither. One of them was probably meant to be an `<xacro:unless>`.
    """
    yield from findings_of(project, ProblemKind.CONDITION_REPEATED)
