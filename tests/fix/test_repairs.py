"""What the repairs that rules suggest make of a part of a robot."""

from __future__ import annotations

from pathlib import Path

import pytest
import robots

from urdfctl.fix.edits import edited
from urdfctl.fix.trial import splices_of
from urdfctl.rules.examples import unmarked

XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{}\n</robot>\n'
WHEEL = '<xacro:macro name="wheel" params="side"><link name="${side}_wheel"/></xacro:macro>\n'


def mended(code: str, part: str, folder: Path, name: str = "robot.urdf", distro: str | None = None) -> tuple[str, bool]:
    """What the edits of a rule's findings make of a text, and whether all are surely meant."""
    path = folder / name
    path.write_bytes(part.encode())
    found = robots.findings(path, (code,), distro=distro, workspace=str(folder))
    assert found
    splices = {splice for finding in found for splice in splices_of(finding)}
    sure = all(finding.fix is not None and finding.fix.safe for finding in found)
    return edited(part.encode(), splices).decode(), sure


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('<wheel side="left"/>', '<xacro:wheel side="left"/>'),
        ('<wheel side="left"></wheel>', '<xacro:wheel side="left"></xacro:wheel>'),
        ('<property name="a" value="1"/>', '<xacro:property name="a" value="1"/>'),
    ],
)
def test_tags_of_xacro_get_their_prefix(before: str, after: str, tmp_path: Path) -> None:
    text, sure = mended("UC018", XACRO.format(WHEEL + before), tmp_path, "robot.xacro")
    assert text == XACRO.format(WHEEL + after)
    assert not sure


@pytest.mark.parametrize(
    "before",
    ['<?xml version="1.0"?>\n<!-- <robot> -->\n<robot name="r">', "<robot\n  name='r'>", '\ufeff<robot name="r">'],
)
def test_the_prefix_that_tags_of_xacro_get_is_declared(before: str, tmp_path: Path) -> None:
    rest = '<{0}property name="a" value="1"/><link name="base"/></robot>'
    text, sure = mended("UC018", before + rest.format(""), tmp_path, "robot.xacro")
    prolog, name = before.rsplit("<robot", 1)
    declared = f'{prolog}<robot xmlns:xacro="http://www.ros.org/wiki/xacro"{name}'
    assert text == declared + rest.format("xacro:")
    assert not sure


def test_braces_get_their_dollar(tmp_path: Path) -> None:
    before = '<xacro:property name="side" value="left"/>\n<link name="größe_{side}_{ side }_${side}"/>'
    text, sure = mended("UC020", XACRO.format(before), tmp_path, "robot.xacro")
    assert '<link name="größe_${side}_${ side }_${side}"/>' in text
    assert not sure


LOOK = "<link name='tip'><visual><geometry><sphere radius='1'/></geometry>{}</visual></link>"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('<material><color rgba="1 0 0 1"/></material>', '<material name=""><color rgba="1 0 0 1"/></material>'),
        (
            "<material ><texture filename='a.png'/></material>",
            "<material name=\"\" ><texture filename='a.png'/></material>",
        ),
    ],
)
def test_a_material_that_says_what_it_looks_like_gets_an_empty_name(before: str, after: str, tmp_path: Path) -> None:
    text, sure = mended("UC144", whole(LOOK.format(before)), tmp_path)
    assert text == whole(LOOK.format(after))
    assert sure


def test_a_material_that_says_nothing_is_for_a_person_to_name(tmp_path: Path) -> None:
    text, sure = mended("UC144", whole(LOOK.format("<material/>")), tmp_path)
    assert text == whole(LOOK.format("<material/>"))
    assert not sure


def whole(part: str) -> str:
    """A part in the small arm of the rules' examples."""
    return next(iter(unmarked({"robot.urdf": part})[0].values()))


@pytest.mark.parametrize(
    ("code", "before", "after", "sure"),
    [
        (
            "UC139",
            "<link name='tip'><inertial><mass value='1\r\n'/></inertial></link>",
            "<link name='tip'><inertial><mass value='1'/></inertial></link>",
            True,
        ),
        (
            "UC154",
            "<link name='tip'><colision><geometry><sphere radius='1'/></geometry></colision ></link>",
            "<link name='tip'><collision><geometry><sphere radius='1'/></geometry></collision ></link>",
            False,
        ),
        (
            "UC154",
            "<link name='tip'><visuel/></link>",
            "<link name='tip'><visual/></link>",
            False,
        ),
        ("UC154", "<link name='tip'><Visual/></link>", "<link name='tip'><visual/></link>", True),
        (
            "UC155",
            "<material name='m' ><color rbga = '1 0 0 1'/></material>",
            "<material name='m' ><color rgba = '1 0 0 1'/></material>",
            False,
        ),
        (
            "UC155",
            "<link name='tip'><visual><origin XYZ='0 0 1'/></visual></link>",
            "<link name='tip'><visual><origin xyz='0 0 1'/></visual></link>",
            True,
        ),
        (
            "UC141",
            "<link name='tip'><visual><geometry><Box size='1 1 1'></Box></geometry></visual></link>",
            "<link name='tip'><visual><geometry><box size='1 1 1'></box></geometry></visual></link>",
            True,
        ),
        (
            "UC147",
            '<material name="grey"><color rgba="192 192 192 0.6"/></material>',
            '<material name="grey"><color rgba="0.753 0.753 0.753 0.6"/></material>',
            False,
        ),
        (
            "UC147",
            '<material name="grey"><color rgba="255 0 51 255"/></material>',
            '<material name="grey"><color rgba="1 0 0.2 1"/></material>',
            False,
        ),
        (
            "UC147",
            '<material name="grey"><color rgba="2.5 0 0 1"/></material>',
            '<material name="grey"><color rgba="2.5 0 0 1"/></material>',
            False,
        ),
    ],
)
def test_numbers_and_names_become_what_was_meant(
    code: str, before: str, after: str, sure: bool, tmp_path: Path
) -> None:
    assert mended(code, whole(before), tmp_path) == (whole(after), sure)


TRANSMISSION = """\
<transmission name="elbow_trans">
  <type>transmission_interface/SimpleTransmission</type>
  <joint name="elbow"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
  ACTUATOR
</transmission>
"""
REDUCTION = "<mechanicalReduction>1</mechanicalReduction>"


@pytest.mark.parametrize(
    ("before", "after", "sure"),
    [
        ('<actuator name="m"/>', f'<actuator name="m">{REDUCTION}</actuator>', False),
        ('<actuator name="m">\n</actuator>', f'<actuator name="m">{REDUCTION}\n</actuator>', False),
        (
            '<actuator name="m"><mechanicalreduction>50</mechanicalreduction></actuator>',
            '<actuator name="m"><mechanicalReduction>50</mechanicalReduction></actuator>',
            True,
        ),
        (
            f'<actuator name="m"/>{REDUCTION}',
            f'<actuator name="m"/>{REDUCTION}',
            False,
        ),
    ],
)
def test_an_actuator_gets_its_reduction_but_for_one_that_stands_elsewhere(
    before: str, after: str, sure: bool, tmp_path: Path
) -> None:
    part = whole(TRANSMISSION.replace("ACTUATOR", before))
    assert mended("UC212", part, tmp_path) == (whole(TRANSMISSION.replace("ACTUATOR", after)), sure)


INTERFACE = """\
<ros2_control name="arm" type="system">
  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <joint name="elbow">
    <command_interface name="KIND">
      <param name="min">MIN</param>
      <param name="max">MAX</param>
    </command_interface>
  </joint>
</ros2_control>
"""


@pytest.mark.parametrize(
    ("kind", "before", "after"),
    [
        ("position", ("-9", "0.5"), ("-1", "0.5")),
        ("velocity", ("-9", "9"), ("-2", "2")),
        ("effort", ("0", "99"), ("0", "10")),
    ],
)
def test_limits_become_those_of_the_urdf(
    kind: str, before: tuple[str, str], after: tuple[str, str], tmp_path: Path
) -> None:
    text, sure = mended("UC334", whole(interface(kind, before)), tmp_path)
    assert text == whole(interface(kind, after))
    assert not sure


def test_a_limit_that_a_comment_stands_in_is_for_a_person_to_change(tmp_path: Path) -> None:
    part = whole(interface("position", ("-9<!-- wide -->", "1")))
    assert mended("UC334", part, tmp_path) == (part, False)


def interface(kind: str, limits: tuple[str, str]) -> str:
    return INTERFACE.replace("KIND", kind).replace("MIN", limits[0]).replace("MAX", limits[1])


COMPONENT = """\
<ros2_control name="arm" type="system">
  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  PART
</ros2_control>
"""


@pytest.mark.parametrize(
    ("code", "before", "after", "sure"),
    [
        ("UC339", '<param name="a" value="1.5"/>', '<param name="a">1.5</param>', True),
        ("UC339", "<param\n value = '1.5' name='a' />", "<param name='a' >1.5</param>", True),
        ("UC339", '<param name="a" value="1.5"></param>', '<param name="a" value="1.5"></param>', False),
        ("UC338", '<state_interfaces name="position"/>', '<state_interface name="position"/>', False),
    ],
)
def test_what_a_joint_of_a_component_holds_becomes_what_was_meant(
    code: str, before: str, after: str, sure: bool, tmp_path: Path
) -> None:
    joint = '<joint name="elbow"><command_interface name="position"/>{}</joint>'
    part = whole(COMPONENT.replace("PART", joint.format(before)))
    assert mended(code, part, tmp_path) == (whole(COMPONENT.replace("PART", joint.format(after))), sure)


@pytest.mark.parametrize(
    ("code", "before", "after"),
    [
        ("UC304", '<joints name="elbow"></joints>', '<joint name="elbow"></joint>'),
        (
            "UC347",
            '<transmission name="t"><plugin>SimpleTransmission</plugin></transmission>',
            '<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin></transmission>',
        ),
    ],
)
def test_what_a_component_holds_becomes_what_was_meant(code: str, before: str, after: str, tmp_path: Path) -> None:
    text, sure = mended(code, whole(COMPONENT.replace("PART", before)), tmp_path)
    assert text == whole(COMPONENT.replace("PART", after))
    assert not sure


MESHES = """\
<robot name="r">
  <link name="a"><visual><geometry><mesh filename="FIRST"/></geometry></visual></link>
  <link name="b"><visual><geometry><mesh filename="../meshes/b.stl"/></geometry></visual></link>
</robot>
"""


def package(folder: Path, *meshes: str) -> None:
    """A package with some meshes, and folders for a robot."""
    (folder / "package.xml").write_text("<package><name>arm_description</name></package>")
    for name in ("urdf", "meshes"):
        (folder / name).mkdir()
    for name in meshes:
        (folder / name).write_text("solid x\nendsolid x\n")


@pytest.mark.parametrize(("code", "address"), [("UC152", "../meshes/a.stl"), ("UC151", "file://{}/meshes/a.stl")])
def test_meshes_get_the_address_of_their_package(code: str, address: str, tmp_path: Path) -> None:
    package(tmp_path, "meshes/a.stl", "meshes/b.stl")
    before = MESHES.replace("FIRST", address.format(tmp_path))
    text, sure = mended(code, before, tmp_path, "urdf/r.urdf")
    assert "package://arm_description/meshes/a.stl" in text
    assert ("package://arm_description/meshes/b.stl" in text) == (code == "UC152")
    assert not sure


@pytest.mark.parametrize("there", [["meshes/a.stl"], ["meshes/b.stl"], []])
def test_meshes_of_which_one_is_not_there_are_for_a_person_to_name(there: list[str], tmp_path: Path) -> None:
    package(tmp_path, *there)
    before = MESHES.replace("FIRST", "../meshes/a.stl")
    assert mended("UC152", before, tmp_path, "urdf/r.urdf") == (before, False)


def test_meshes_in_no_package_are_for_a_person_to_name(tmp_path: Path) -> None:
    package(tmp_path, "meshes/a.stl", "meshes/b.stl")
    (tmp_path / "package.xml").unlink()
    before = MESHES.replace("FIRST", "../meshes/a.stl")
    assert mended("UC152", before, tmp_path, "urdf/r.urdf") == (before, False)


def test_old_hardware_gets_its_new_name_with_the_new_names_of_its_parameters(tmp_path: Path) -> None:
    parameters = '<param name="{}_sensor_commands">true</param><param name="other">1</param>'
    before = "<plugin>fake_components/GenericSystem</plugin>" + parameters.format("fake")
    after = "<plugin>mock_components/GenericSystem</plugin>" + parameters.format("mock")
    component = COMPONENT.replace("PART", "<joint name='elbow'><command_interface name='position'/></joint>")
    old = "<plugin>mock_components/GenericSystem</plugin>"
    text, sure = mended("UC703", whole(component.replace(old, before)), tmp_path, distro="humble")
    assert text == whole(component.replace(old, after))
    assert not sure
