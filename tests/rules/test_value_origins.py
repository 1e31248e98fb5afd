"""A wrong value is named where it is written: in a property, or in the call of the macro that it is passed to."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots

DESCRIPTION = """<robot name="turret" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="servo.xacro"/>
  <link name="base"/>
  <xacro:servo name="pan" lower="{lower}" upper="{upper}" effort="{effort}"/>
</robot>
"""
SERVO = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="servo_effort" value="{property}"/>
  <xacro:macro name="servo" params="name lower upper effort speed:=5.0 effort_of_all:=2">
    <link name="${{name}}_link">
      <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    </link>
    <joint name="${{name}}" type="revolute">
      <parent link="base"/><child link="${{name}}_link"/>
      <limit lower="${{lower}}" upper="${{upper}}" effort="${{effort}}" velocity="${{speed}}"/>
    </joint>
  </xacro:macro>
</robot>
"""
SOUND = {"lower": "-1", "upper": "1", "effort": "${servo_effort}", "property": "2"}


def found(folder: Path, code: str, **values: str) -> list[tuple[str, int, str, list[str]]]:
    """Return the file, line, text and repaired texts of each finding of a rule."""
    for name, text in {"turret.xacro": DESCRIPTION, "servo.xacro": SERVO}.items():
        (folder / name).write_text(text.format(**{**SOUND, **values}), "utf-8")
    return [
        (
            Path(one.at.file).name,
            one.at.line,
            Path(one.at.file).read_bytes()[one.at.start : one.at.end].decode(),
            [edit.text for edit in one.fix.edits] if one.fix else [],
        )
        for one in robots.findings(folder / "turret.xacro", (code,), workspace=str(folder))
    ]


@pytest.mark.parametrize(
    ("code", "values", "where"),
    [
        ("UC127", {"property": "2Nm"}, ("servo.xacro", 2, "2Nm", [])),
        ("UC127", {"property": "2,5"}, ("servo.xacro", 2, "2,5", ["2.5"])),
        ("UC127", {"effort": "3Nm"}, ("turret.xacro", 4, "3Nm", [])),
        ("UC125", {"lower": "1", "upper": "-1"}, ("turret.xacro", 4, "1", ["-1", "1"])),
    ],
)
def test_a_wrong_value_is_named_where_it_is_written(
    code: str, values: dict[str, str], where: tuple[str, int, str, list[str]], tmp_path: Path
) -> None:
    assert found(tmp_path, code, **values) == [where]


def test_a_value_that_is_put_together_is_named_where_it_is_used(tmp_path: Path) -> None:
    [(file, line, text, _)] = found(tmp_path, "UC127", effort="3${' Nm'}")
    assert (file, line, text) == ("turret.xacro", 4, "3${' Nm'}")


def test_a_property_that_is_defined_twice_is_not_guessed(tmp_path: Path) -> None:
    twice = '${servo_effort}"/><xacro:property name="servo_effort" value="2'
    [(file, line, _, _)] = found(tmp_path, "UC127", property="2Nm", effort=twice)
    assert (file, line) == ("turret.xacro", 4)


@pytest.mark.parametrize("code", ["UC127", "UC125"])
def test_sound_values_are_not_named(code: str, tmp_path: Path) -> None:
    assert found(tmp_path, code) == []
