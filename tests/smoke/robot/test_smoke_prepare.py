"""The robot as engines load it: masses and inertias, joints, wheels as cylinders, and the meshes that engines read."""

from __future__ import annotations

import math
import struct
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from urdfctl.model.geometry import Pose, Rotation, of_angles
from urdfctl.model.robot.build_robot import robot_of
from urdfctl.smoke.engines.urdf import EngineUrdf, engine_urdf, mechanism_urdf, mesh_fault, wheel_links
from urdfctl.smoke.robot.description import mechanism_of
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.source.span import SourceText
from urdfctl.source.xml.parsing import parse

JOINT = Hinge("j", "revolute", parent="base", child="arm", pose=Pose(), axis=(0.0, 0.0, 1.0), lower=-1.0, upper=1.0)


def square(xx: float, yy: float, zz: float, xy: float = 0.0) -> Rotation:
    return (xx, xy, 0.0), (xy, yy, 0.0), (0.0, 0.0, zz)


def written(body: LinkBody, hinge: Hinge = JOINT, damped: tuple[str, ...] = ()) -> ET.Element:
    text = mechanism_urdf(Mechanism("base", {"base": LinkBody("base", 1.0), "arm": body}, (hinge,)), None, damped)
    return ET.fromstring(text)


def moments(inertia: Rotation, mass: float = 1.0) -> list[float]:
    made = written(LinkBody("arm", mass, inertia=inertia)).find("link[@name='arm']/inertial/inertia")
    assert made is not None
    return [float(made.attrib[name]) for name in ("ixx", "iyy", "izz", "ixy")]


@pytest.mark.parametrize(("kind", "expected"), [("revolute", 0.001), ("fixed", 0.0)])
def test_a_moving_link_without_mass_gets_the_gram_that_the_report_names(kind: str, expected: float) -> None:
    mass = written(LinkBody("arm"), JOINT._replace(type=kind)).find("link[@name='arm']/inertial/mass")
    assert mass is not None
    assert float(mass.attrib["value"]) == expected


def test_a_possible_inertia_is_kept() -> None:
    assert moments(square(1.0, 2.0, 2.5, 0.3)) == [1.0, 2.0, 2.5, 0.3]
    assert moments(square(1.0, 2.0, 3.0)) == [1.0, 2.0, 3.0, 0.0]


@pytest.mark.parametrize("inertia", [square(1.0, 1.0, 4.0), square(1.0, 1.0, 1.0, 1.5), square(-1.0, 4.0, 3.0)])
def test_an_impossible_inertia_becomes_that_of_a_ball_with_the_same_sum(inertia: Rotation) -> None:
    """Its largest moment exceeds the sum of the others, or one is negative."""
    mean = sum(inertia[n][n] for n in range(3)) / 3
    assert moments(inertia) == pytest.approx([mean, mean, mean, 0.0])


def test_a_mass_without_inertia_gets_a_small_one() -> None:
    xx, yy, zz, _ = moments(square(0.0, 0.0, 0.0), 5.0)
    assert 0 < xx == yy == zz < 0.1


def resistance(damped: tuple[str, ...]) -> tuple[str, str]:
    joint = written(LinkBody("arm", 1.0), JOINT._replace(damping=0.5, friction=0.25), damped).find("joint/dynamics")
    assert joint is not None
    return joint.attrib["damping"], joint.attrib["friction"]


def test_only_joints_that_efforts_push_keep_their_resistance() -> None:
    assert resistance(("j",)) == ("0.5", "0.25")
    assert resistance(()) == ("0.0", "0.0")


@pytest.mark.parametrize(
    ("roll", "pitch", "yaw"),
    [(0.0, 0.0, 0.0), (0.3, -0.4, 0.5), (0.3, math.pi / 2, 0.5), (0.3, -math.pi / 2, 0.5), (3.0, 1.5, -3.0)],
)
def test_the_angles_of_a_joint_are_those_of_its_rotation(roll: float, pitch: float, yaw: float) -> None:
    pose = Pose((1.0, 2.0, 3.0), of_angles(roll, pitch, yaw))
    origin = written(LinkBody("arm", 1.0), JOINT._replace(pose=pose)).find("joint/origin")
    assert origin is not None
    again = of_angles(*map(float, origin.attrib["rpy"].split()))
    for row, expected in zip(again, pose.turn, strict=True):
        assert row == pytest.approx(expected, abs=1e-9)


def test_a_joint_of_an_unknown_type_is_fixed() -> None:
    assert written(LinkBody("arm", 1.0), JOINT._replace(type="planar")).find("joint[@type='fixed']") is not None
    assert written(LinkBody("arm", 1.0)).find("joint[@type='revolute']") is not None


# -- collision geometry ----------------------------------------------------------------------------------------------


def with_shape(shape: str, *, standing: bool = True, wheel: float | None = None, mesh: str | None = None) -> EngineUrdf:
    """Return a robot whose only moving link turns about y and has a shape, or is a wheel of some radius."""
    collision = f"<collision><geometry>{shape}</geometry></collision>"
    axis = '<axis xyz="0 1 0"/><parent link="base"/><child link="arm"/>'
    text = f'<robot name="r"><link name="base"/><link name="arm">{collision}</link>'
    root = parse(SourceText("/r.urdf", f'{text}<joint name="j" type="continuous">{axis}</joint></robot>'.encode()))
    assert root.documentElement is not None
    robot = robot_of(root.documentElement)
    mechanism = mechanism_of(robot)
    assert mechanism is not None
    wheels = wheel_links(mechanism, ["j"], wheel) if wheel is not None else {}
    return engine_urdf(robot, mechanism, lambda _: mesh, wheels, standing=standing)


@pytest.mark.parametrize(
    "shape", ['<box size="1 2 3"/>', '<cylinder radius="0.1" length="0.2"/>', '<sphere radius="0.1"/>']
)
def test_shapes_are_kept_on_the_ground_only(shape: str) -> None:
    found = ET.fromstring(with_shape(shape).urdf).find("link/collision/geometry")
    assert found is not None
    assert shape.startswith(f"<{found[0].tag} ")
    assert "collision" not in with_shape(shape, standing=False).urdf
    assert with_shape(shape).left_out == {}


@pytest.mark.parametrize(
    "shape", ['<box size="1 0 3"/>', '<sphere radius="-1"/>', '<sphere radius="wide"/>', "<sphere/>"]
)
def test_a_shape_without_a_positive_size_is_left_out(shape: str) -> None:
    made = with_shape(shape)
    assert set(made.left_out) == set(made.broken) == {"arm"}
    assert "has no positive size" in made.left_out["arm"]
    assert "collision" not in made.urdf


def test_a_shape_that_urdf_does_not_know_is_none() -> None:
    made = with_shape('<cone radius="1"/>')
    assert (made.left_out, "collision" in made.urdf) == ({}, False)


def test_a_wheel_without_its_mesh_is_a_cylinder_of_the_controllers_radius_some_centimetres_wide() -> None:
    made = with_shape('<mesh filename="package://p/wheel.stl"/>', wheel=0.15)
    assert made.left_out == {"arm": "'package://p/wheel.stl' was not found"}
    assert made.broken == {}
    cylinder = ET.fromstring(made.urdf).find("link/collision/geometry/cylinder")
    assert cylinder is not None
    assert float(cylinder.attrib["radius"]) == 0.15
    assert 0.02 < float(cylinder.attrib["length"]) < 0.1
    assert "cylinder" not in with_shape('<mesh filename="package://p/wheel.stl"/>').urdf
    assert "cylinder" not in with_shape('<mesh filename="package://p/wheel.stl"/>', wheel=0.0).urdf


# -- meshes ----------------------------------------------------------------------------------------------------------


def stl(triangles: int, given: int | None = None, header: bytes = b"") -> bytes:
    count = triangles if given is None else given
    return header.ljust(80) + struct.pack("<I", count) + struct.pack("<12fH", *([0.0] * 12), 0) * triangles


@pytest.mark.parametrize(
    ("name", "data", "fault"),
    [
        ("a.stl", stl(2), ""),
        ("a.stl", stl(0), "is not a complete STL file"),
        ("a.stl", stl(1, 2), "is not a complete STL file"),
        ("a.stl", b"short", "is not a complete STL file"),
        ("a.stl", b"solid a\nfacet\nvertex 0 0 0", ""),
        ("a.stl", b"solid a\nfacet\n", "has no triangles"),
        ("a.stl", stl(2, header=b"solid a"), ""),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ""),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n", ""),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a corner that does not exist"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a corner that does not exist"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no faces"),
        ("a.dae", b"<COLLADA><triangles/></COLLADA>", ""),
        ("a.dae", b"<COLLADA><polylist/></COLLADA>", ""),
        ("a.dae", b"<COLLADA/>", "has no triangles"),
        ("a.dae", b"<COLLADA>", "is not well-formed XML"),
        ("a.ply", b"ply", "has the file type '.ply'"),
    ],
)
def test_a_mesh_that_engines_cannot_read_is_named_with_its_fault(
    name: str, data: bytes, fault: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(data)
    told = mesh_fault(str(tmp_path / name))
    assert (told == "") == (fault == "")
    assert fault in told


@pytest.mark.parametrize(("mebibytes", "large"), [(19, False), (21, True)])
def test_a_mesh_of_more_than_twenty_mebibytes_is_not_loaded(mebibytes: int, large: bool, tmp_path: Path) -> None:
    with open(tmp_path / "a.stl", "wb") as file:
        file.write(stl(2))
        file.truncate(mebibytes << 20)
    assert ("is larger than 20 MiB" in mesh_fault(str(tmp_path / "a.stl"))) == large
