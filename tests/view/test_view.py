"""`urdfctl view` shows a robot in 3-D: links where a physics engine has them, joints in the colour of their control."""

from __future__ import annotations

import json
import math
import random
import struct
import zlib
from pathlib import Path
from typing import Any

import pytest
from folder import Folder
from pages import Elements, in_node, needs_node
from smoking_engines import needs_pybullet

from urdfctl.config.settings import Settings
from urdfctl.load.target import Target
from urdfctl.view.html import html
from urdfctl.view.image import poses_of
from urdfctl.view.job import portraits
from urdfctl.view.meshes import NotAMesh, installed, merged, packed, read_mesh

pytestmark = pytest.mark.skipif(not installed(), reason="the extra 'view' is not installed")

ARM = """\
<robot name="r">
  <material name="orange"><color rgba="1 0.5 0 1"/></material>
  <link name="base"><visual><geometry><box size="0.4 0.4 0.1"/></geometry><material name="orange"/></visual></link>
  <link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="tool"/>
  <joint name="one" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0.1 0 0.3" rpy="0.3 -0.2 1.1"/>
    <axis xyz="0.2 0.9 -0.4"/><limit lower="-1" upper="2" effort="5" velocity="1"/></joint>
  <joint name="two" type="continuous"><parent link="a"/><child link="b"/><origin xyz="0 0.2 0.1" rpy="1.4 0 0"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="three" type="prismatic"><parent link="b"/><child link="c"/><origin rpy="0 0.7 0.1"/>
    <axis xyz="0.6 0.8 0"/><limit lower="0" upper="0.4" effort="5" velocity="1"/></joint>
  <joint name="four" type="revolute"><parent link="b"/><child link="d"/><axis xyz="0 1 0"/>
    <limit lower="-3" upper="3" effort="5" velocity="1"/><mimic joint="one" multiplier="-1.5" offset="0.1"/></joint>
  <joint name="end" type="fixed"><parent link="d"/><child link="tool"/><origin xyz="0 0 0.2" rpy="0 0 2"/></joint>
</robot>
"""


def scene_in(folder: Path, files: dict[str, str | bytes], **target: Any) -> dict[str, Any]:
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    [portrait] = portraits([Target(str(folder / "robot.urdf"), **target)], Settings(distro="jazzy"), in_3d=True)
    assert portrait.scene is not None, portrait.failure
    return portrait.scene


@needs_node
@needs_pybullet
def test_links_are_where_a_physics_engine_has_them(tmp_path: Path) -> None:
    import pybullet

    scene = scene_in(tmp_path, {"robot.urdf": ARM})
    dice = random.Random(7)  # noqa: S311
    free = {"one": (-1, 2), "two": (-3, 3), "three": (0, 0.4)}
    tried = [{name: dice.uniform(*span) for name, span in free.items()} for _ in range(20)]
    script = f"console.log(JSON.stringify({json.dumps(tried)}.map(given => posesOf({json.dumps(scene)}, given))))"
    shown = in_node(script, "kinematics.js")
    client = pybullet.connect(pybullet.DIRECT)
    try:
        robot = pybullet.loadURDF(str(tmp_path / "robot.urdf"), useFixedBase=True, physicsClientId=client)
        number = pybullet.getNumJoints(robot, physicsClientId=client)
        joints = [pybullet.getJointInfo(robot, n, physicsClientId=client) for n in range(number)]
        for positions, poses in zip(tried, shown, strict=True):
            known = {**positions, "four": -1.5 * positions["one"] + 0.1}
            for joint in joints:
                if joint[1].decode() in known:
                    pybullet.resetJointState(robot, joint[0], known[joint[1].decode()], physicsClientId=client)
            for joint in joints:
                state = pybullet.getLinkState(robot, joint[0], computeForwardKinematics=True, physicsClientId=client)
                expected = [*pybullet.getMatrixFromQuaternion(state[5]), *state[4]]
                assert poses[joint[12].decode()] == pytest.approx(expected, abs=1e-6)
    finally:
        pybullet.disconnect(client)


CONTROLLED = """\
<robot name="r">
  <link name="base"/><link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/><link name="f"/>
  {joints}
  <ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="ja"><command_interface name="position"/><state_interface name="position"/></joint>
    <joint name="jb"><command_interface name="velocity"/><state_interface name="velocity"/></joint>
    <joint name="jc"><command_interface name="effort"/><state_interface name="position"/></joint>
    <joint name="jd"><state_interface name="position"/></joint>
  </ros2_control>
</robot>
""".replace(
    "{joints}",
    "\n".join(
        f'<joint name="j{x}" type="revolute"><parent link="base"/><child link="{x}"/><axis xyz="0 0 1"/>'
        f'<limit lower="-1" upper="1" effort="5" velocity="2"/>{more}</joint>'
        for x, more in zip("abcdef", ["", "", "", "", '<mimic joint="ja"/>', ""], strict=True)
    ),
)
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    pos: {type: forward_command_controller/ForwardCommandController}
    vel: {type: forward_command_controller/ForwardCommandController}
    eff: {type: forward_command_controller/ForwardCommandController}
pos: {ros__parameters: {joints: [ja], interface_name: position}}
vel: {ros__parameters: {joints: [jb], interface_name: velocity}}
eff: {ros__parameters: {joints: [jc], interface_name: effort}}
"""


def test_joints_have_the_colour_of_their_control(tmp_path: Path) -> None:
    files: dict[str, str | bytes] = {"robot.urdf": CONTROLLED, "c.yaml": CONTROLLERS}
    scene = scene_in(tmp_path, files, controllers=(str(tmp_path / "c.yaml"),))
    controls = {joint["name"]: joint["control"] for joint in scene["joints"]}
    assert controls == {"ja": "position", "jb": "velocity", "jc": "effort", "jd": "state", "je": "mimic", "jf": "none"}
    facts = dict(scene["joints"][0]["facts"])
    assert facts["limits"] == "-1 to 1 rad, 2 rad/s, 5 N m"
    assert facts["commanded by"] == "pos (forward_command_controller/ForwardCommandController)"
    assert facts["hardware"] == "hw (mock_components/GenericSystem)"


def test_an_error_about_a_joint_is_on_that_joint_alone(tmp_path: Path) -> None:
    files: dict[str, str | bytes] = {
        "robot.urdf": CONTROLLED,
        "c.yaml": CONTROLLERS.replace("[jb], interface_name: velocity", "[jb], interface_name: effort"),
    }
    scene = scene_in(tmp_path, files, controllers=(str(tmp_path / "c.yaml"),))
    assert [joint["name"] for joint in scene["joints"] if joint["error"]] == ["jb"]
    [finding] = [finding for joint in scene["joints"] if joint["error"] for finding in joint["findings"]]
    assert finding["severity"] == "error"
    assert finding["at"].partition(":")[0].endswith(("c.yaml", "robot.urdf"))


def test_sliders_stay_within_the_limits(tmp_path: Path) -> None:
    elements = Elements(html(scene_in(tmp_path, {"robot.urdf": ARM}), "robot.urdf"))
    ranges = {
        a["aria-label"]: (float(a["min"] or ""), float(a["max"] or ""))
        for a in elements.named("input")
        if a["type"] == "range"
    }
    assert ranges == {
        "position of one in rad": (-1, 2),
        "position of two in rad": (pytest.approx(-math.pi), pytest.approx(math.pi)),
        "position of three in m": (0, 0.4),
    }, "the joint that mimics another has no slider"


def test_the_page_needs_no_network_and_escapes_what_files_say(tmp_path: Path) -> None:
    wicked = ARM.replace('name="tool"', 'name="&lt;/script&gt;&lt;script&gt;alert(1)"').replace(
        'link="tool"', 'link="&lt;/script&gt;&lt;script&gt;alert(1)"'
    )
    text = html(scene_in(tmp_path, {"robot.urdf": wicked}), "robot.urdf")
    elements = Elements(text)
    assert elements.addresses == []
    assert "http" not in text.replace("<meta http-equiv=", "")
    assert len(elements.named("script")) == 4, "the scene and the scripts"
    assert "alert(1)" not in "".join(elements.scripts[1:])


def test_broken_trees_are_shown_as_far_as_they_go(tmp_path: Path) -> None:
    broken = ARM.replace(
        "</robot>",
        '<link name="lost"/><joint name="loop" type="fixed"><parent link="tool"/><child link="a"/></joint></robot>',
    )
    scene = scene_in(tmp_path, {"robot.urdf": broken})
    assert "lost" in scene["links"]
    assert scene["notes"] == ["joint 'loop' is left out: the links form no tree with it"]
    assert [joint["name"] for joint in scene["joints"]] == ["one", "two", "three", "four", "end"]


# -- meshes ----------------------------------------------------------------------------------------------------------

CORNERS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 3.0)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
STL = b" " * 80 + struct.pack("<I", len(FACES)) + b"".join(
    struct.pack("<12fH", 0, 0, 0, *CORNERS[a], *CORNERS[b], *CORNERS[c], 0) for a, b, c in FACES
)  # fmt: skip
OBJ = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)
DAE = f"""\
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
  <library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong>
    <diffuse><color>0 0.6 0.2 1</color></diffuse></phong></technique></profile_COMMON></effect></library_effects>
  <library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="pa" count="12">{" ".join(str(100 * v) for c in CORNERS for v in c)}</float_array>
      <technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4" material="s"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>{" ".join(str(n) for face in FACES for n in face)}</p></triangles></mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
    <instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node>
  </visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""


@pytest.mark.parametrize(("kind", "data"), [("stl", STL), ("obj", OBJ.encode()), ("dae", DAE.encode())])
def test_each_kind_of_mesh_has_its_size_in_metres_and_its_up_axis_unturned(kind: str, data: bytes) -> None:
    [surface] = merged(read_mesh(data, kind))
    assert surface.points.min(axis=0).tolist() == pytest.approx([0, 0, 0])
    assert surface.points.max(axis=0).tolist() == pytest.approx([1, 2, 3])
    assert len(surface.faces) == 4
    if kind == "dae":
        assert surface.colour == pytest.approx((0, 0.6, 0.2, 1), abs=0.01)


@pytest.mark.parametrize("kind", ["stl", "obj", "dae"])
@pytest.mark.parametrize("data", [b"", b"<html>404</html>", b"\xff" * 300])
def test_a_file_that_is_no_mesh_is_refused_with_its_kind(kind: str, data: bytes) -> None:
    with pytest.raises(NotAMesh, match=kind.upper()):
        read_mesh(data, kind)


def test_meshes_are_found_as_lint_finds_them_and_missing_ones_are_marked(tmp_path: Path) -> None:
    visuals = [
        "package://own/meshes/a.stl",
        "meshes/a.stl",
        f"file://{tmp_path}/meshes/b.dae",
        "package://own/meshes/gone.stl",
        "meshes/broken.obj",
    ]
    shapes = "".join(f'<visual><geometry><mesh filename="{name}"/></geometry></visual>' for name in visuals)
    scene = scene_in(
        tmp_path,
        {
            "robot.urdf": f'<robot name="r"><link name="base">{shapes}</link></robot>',
            "package.xml": "<package><name>own</name></package>",
            "meshes/a.stl": STL,
            "meshes/b.dae": DAE,
            "meshes/broken.obj": "404: not found",
        },
    )
    parts = scene["links"]["base"]
    assert [part["shape"] for part in parts] == ["mesh", "mesh", "mesh", "missing", "missing"]
    assert [note.split(" ")[0].rstrip(":") for note in scene["notes"]] == visuals[3:]
    assert "has no triangles" in scene["notes"][1] or "cannot be read" in scene["notes"][1]


@pytest.mark.parametrize(
    ("collision", "shown"),
    [('<box size="1 2 3"/>', ["box"]), ('<mesh filename="meshes/gone_too.stl"/>', ["missing"]), ("", ["missing"])],
)
def test_where_all_visual_meshes_are_missing_the_collision_shapes_are_shown(
    tmp_path: Path, collision: str, shown: list[str]
) -> None:
    visual = '<visual><geometry><mesh filename="meshes/gone.stl"/></geometry></visual>'
    solid = f"<collision><geometry>{collision}</geometry></collision>"
    robot = f'<robot name="r"><link name="base">{visual}{solid}</link></robot>'
    scene = scene_in(tmp_path, {"robot.urdf": robot})
    assert [part["shape"] for part in scene["links"]["base"]] == shown
    assert any("gone.stl" in note for note in scene["notes"])


def ball(rings: int) -> bytes:
    import trimesh

    data = trimesh.creation.uv_sphere(radius=1.0, count=(rings, rings)).export(file_type="stl")
    return bytes(data)


@needs_node
def test_packed_meshes_are_unpacked_to_the_same_corners() -> None:
    [surface] = merged(read_mesh(ball(20), "stl"))
    data = packed(surface, 1.0)
    script = f"const s = surfaceOf({json.dumps(data)}); console.log(JSON.stringify([...s.corners, ...s.faces]))"
    values = in_node(script, "robot_shapes.js")
    corners = list(zip(*[iter(values[: -3 * data["triangles"]])] * 3, strict=True))
    faces = list(zip(*[iter(values[-3 * data["triangles"] :])] * 3, strict=True))
    found = sorted(tuple(round(v, 3) for v in corners[n]) for face in faces for n in face)
    wanted = sorted(tuple(round(float(v), 3) for v in surface.points[n]) for face in surface.faces for n in face)
    assert len(found) == len(wanted)
    assert all(math.dist(a, b) < 0.003 for a, b in zip(found, wanted, strict=True))


def test_meshes_with_too_many_triangles_are_simplified() -> None:
    [surface] = merged(read_mesh(ball(100), "stl"))
    simple = packed(surface, 0.1)
    assert 300 < simple["triangles"] <= len(surface.faces) * 0.1
    assert simple["size"] == pytest.approx([2, 2, 2], abs=0.01)


@needs_node
def test_every_shape_has_its_size() -> None:
    shapes = {"box": [1, 2, 3], "cylinder": [0.5, 2], "sphere": [0.7], "capsule": [0.2, 1], "missing": [0.05]}
    parts = [{"shape": shape, "size": size} for shape, size in shapes.items()]
    script = f"""const reach = corners => [0, 1, 2].map(n => Math.max(...corners.filter((_, m) => m % 3 === n)));
    console.log(JSON.stringify({json.dumps(parts)}.map(part => reach([...surfacesOf(part, [])[0].corners]))))"""
    box, cylinder, sphere, capsule, _ = in_node(script, "robot_shapes.js")
    assert box == [0.5, 1, 1.5]
    assert cylinder == pytest.approx([0.5, 0.5, 1])
    assert sphere == pytest.approx([0.7, 0.7, 0.7])
    assert capsule == pytest.approx([0.2, 0.2, 0.7])


# -- the command -----------------------------------------------------------------------------------------------------


def test_the_command_writes_the_page(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    run = folder.run("view", "robot.urdf", "-o", "page.html")
    assert run.returncode == 0, run.stderr
    assert "<title>r in 3-D</title>" in (folder.path / "page.html").read_text(encoding="utf-8")


def test_a_robot_without_links_is_one_line(folder: Folder) -> None:
    folder.write({"robot.urdf": '<robot name="r"/>'})
    run = folder.run("view", "robot.urdf")
    assert run.returncode == 2
    assert len(run.stderr.splitlines()) == 1


@needs_node
def test_the_picture_has_the_links_where_the_page_has_them(tmp_path: Path) -> None:
    scene = scene_in(tmp_path, {"robot.urdf": ARM})
    shown = in_node(f"console.log(JSON.stringify(posesOf({json.dumps(scene)}, {{}})))", "kinematics.js")
    for link, pose in poses_of(scene["joints"]).items():
        assert [*(part for row in pose.turn for part in row), *pose.place] == pytest.approx(shown[link], abs=1e-9)


def pixels_of(data: bytes) -> tuple[int, int, bytes]:
    width, height = struct.unpack(">II", data[16:24])
    start = data.index(b"IDAT") + 4
    size = int.from_bytes(data[start - 8 : start - 4], "big")
    return width, height, zlib.decompress(data[start : start + size])


def test_a_picture_is_written_instead_of_the_page(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    run = folder.run("view", "robot.urdf", "--image", "robot.png")
    assert run.returncode == 0, run.stderr
    assert not (folder.path / "robot.html").exists()
    width, height, rows = pixels_of((folder.path / "robot.png").read_bytes())
    assert len(rows) == height * (1 + 4 * width)
    row = rows[(height // 2) * (1 + 4 * width) + 1 :][: 4 * width]
    red, green, blue, cover = row[4 * (width // 2) :][:4]
    assert cover == 255, "the box is in the middle"
    assert red > green > blue, "and orange"
    assert row[3] == 0, "the ground is transparent"


def test_a_picture_of_another_kind_is_one_line(folder: Folder) -> None:
    folder.write({"robot.urdf": ARM})
    run = folder.run("view", "robot.urdf", "--image", "robot.gif")
    assert (run.returncode, run.stderr) == (2, "urdfctl: 'robot.gif' is not a PNG: only .png can be written\n")
