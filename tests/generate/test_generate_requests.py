"""Several controllers at once: over chosen joints, from a list's columns, or proposed from the robot."""

from __future__ import annotations

import re
from typing import Any

import pytest
from folder import Folder
from generating import command, read

WEIGHT = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
LIMIT = '<limit lower="-1" upper="1" effort="50" velocity="2"/>'


def joint(
    name: str, parent: str, *, kind: str = "revolute", axis: str = "0 1 0", at: str = "0 0 0.3", more: str = ""
) -> str:
    """A joint with the link `NAME_link`."""
    return (
        f'<link name="{name}_link">{WEIGHT}</link><joint name="{name}" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{name}_link"/><origin xyz="{at}"/><axis xyz="{axis}"/>{LIMIT}{more}</joint>'
    )


def wheel(name: str, x: float, y: float, parent: str = "base") -> str:
    """A wheel of 0.1 m."""
    shape = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    text = joint(name, parent, kind="continuous", at=f"{x} {y} 0")
    return text.replace("</inertial></link>", f"</inertial>{shape}</link>")


def robot(*parts: str) -> str:
    return f'<robot name="r"><link name="base">{WEIGHT}</link>{"".join(parts)}</robot>'


ARM = (
    joint("shoulder", "base", axis="0 0 1"),
    joint("elbow", "shoulder_link"),
    joint("wrist", "elbow_link"),
)
HAND = (
    joint("finger", "wrist_link", kind="prismatic"),
    joint("finger_2", "wrist_link", kind="prismatic", more='<mimic joint="finger" multiplier="-1"/>'),
)
WHEELS = (wheel("left_wheel", 0, 0.2), wheel("right_wheel", 0, -0.2))
FOUR = tuple(
    wheel(f"{end}_{side}", x, y) for end, x in (("f", 0.3), ("r", -0.3)) for side, y in (("l", 0.2), ("r", -0.2))
)
CASTER = (
    joint("swivel", "base", kind="continuous", axis="0 0 1", at="-0.3 0 0.1"),
    wheel("caster_wheel", -0.05, 0, "swivel_link").replace('xyz="-0.05 0 0"', 'xyz="-0.05 0 -0.1"'),
)
CAR = (
    wheel("rear_left", -0.3, 0.2),
    wheel("rear_right", -0.3, -0.2),
    joint("steer_left", "base", axis="0 0 1", at="0.3 0.2 0"),
    joint("steer_right", "base", axis="0 0 1", at="0.3 -0.2 0"),
    wheel("front_left", 0, 0, "steer_left_link"),
    wheel("front_right", 0, 0, "steer_right_link"),
)


def written(folder: Folder, text: str, *words: str, distro: str = "jazzy") -> dict[str, Any]:
    """The controllers of a file, by name, without the broadcaster."""
    folder.write({"r.urdf": text})
    ran = command("gen-controllers", "r.urdf", "--distro", distro, "--no-broadcaster", *words)
    assert ran.returncode == 0, ran.stderr
    plain = read(ran.stdout)
    types = plain.pop("controller_manager", {}).get("ros__parameters", {})
    parameters = {name: part.get("ros__parameters", part) for name, part in plain.items()}
    named = [name for name, part in types.items() if isinstance(part, dict)] or list(plain)
    return {name: {**parameters.get(name, {}), **(types.get(name) or {})} for name in named}


def refused(folder: Folder, text: str, *words: str, distro: str = "jazzy") -> str:
    """The line that refuses a command."""
    folder.write({"r.urdf": text})
    ran = command("gen-controllers", "r.urdf", "--distro", distro, *words)
    assert (ran.returncode, ran.stdout, ran.stderr.count("\n")) == (2, "", 1)
    return ran.stderr.removeprefix("urdfctl: ").strip()


def test_a_car_whose_steering_has_positions_and_whose_wheels_have_velocities_is_still_a_car(folder: Folder) -> None:
    interfaces = {
        "rear_left": "velocity",
        "rear_right": "velocity",
        "steer_left": "position",
        "steer_right": "position",
    }
    joints = "".join(
        f'<joint name="{name}"><command_interface name="{one}"/><state_interface name="position"/>'
        f'<state_interface name="velocity"/></joint>'
        for name, one in interfaces.items()
    )
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    component = f'<ros2_control name="hw" type="system">{hardware}{joints}</ros2_control>'
    found = written(folder, robot(*CAR, component))
    assert "base_controller" in found
    assert "wheel_controller" not in found


def test_each_controller_gets_the_joints_that_it_names(folder: Folder) -> None:
    found = written(
        folder,
        robot(*ARM, *HAND, *WHEELS),
        *("--controller", "arm=trajectory:shoulder,e.*,wrist", "--controller", "hand=gripper:finger"),
        *("--controller", "base=diff_drive"),
    )
    assert list(found) == ["arm", "hand", "base"]
    assert found["arm"]["joints"] == ["shoulder", "elbow", "wrist"]
    assert found["hand"]["joint"] == "finger"
    assert found["base"]["left_wheel_names"] == ["left_wheel"]


def test_a_controller_without_joints_gets_those_that_remain_and_fit_it(folder: Folder) -> None:
    types = ("--type", "trajectory", "--type", "gripper", "--type", "diff_drive")
    found = written(folder, robot(*ARM, *HAND, *WHEELS, *CASTER), *types)
    assert found["joint_trajectory_controller"]["joints"] == ["shoulder", "elbow", "wrist"]
    assert found["finger_gripper_controller"]["joint"] == "finger"
    assert found["diff_drive_controller"]["right_wheel_names"] == ["right_wheel"]


def test_each_controller_commands_the_interfaces_that_it_names(folder: Folder) -> None:
    words = ("arm=trajectory[effort]:shoulder,elbow", "wrist=trajectory[position,velocity]:wrist", "base=diff_drive")
    text = robot(*ARM, *WHEELS)
    found = written(folder, text, *(word for one in words for word in ("--controller", one)), "--interface", "velocity")
    assert found["arm"]["command_interfaces"] == ["effort"]
    assert list(found["arm"]["gains"]) == ["shoulder", "elbow"]
    assert found["wrist"]["command_interfaces"] == ["position", "velocity"]
    folder.write({"list.csv": "name,interface\nelbow,velocity\n"})
    found = written(folder, text, "list.csv", "--controller", "arm=trajectory[effort]", distro="noetic")
    assert found["arm"]["type"] == "effort_controllers/JointTrajectoryController"
    component = """<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
        </hardware><joint name="elbow"><command_interface name="velocity"/></joint></ros2_control>"""
    line = refused(folder, robot(*ARM, component), "--controller", "arm=trajectory[effort]:elbow")
    assert "which has only 'velocity' in <ros2_control>: use --controller arm=trajectory[velocity], or add" in line


def test_a_gripper_alone_gets_the_fingers_and_a_drive_the_wheels_without_casters(folder: Folder) -> None:
    assert list(written(folder, robot(*ARM, *HAND), "--type", "gripper")) == ["finger_gripper_controller"]
    aside = [part.replace('xyz="-0.3 0 0.1"', 'xyz="-0.3 0.1 0.1"') for part in CASTER]
    found = written(folder, robot(*WHEELS, *aside), "--type", "diff_drive")["diff_drive_controller"]
    assert (found["left_wheel_names"], found["right_wheel_names"]) == (["left_wheel"], ["right_wheel"])


def test_two_controllers_of_the_same_joints_are_refused_unless_both_name_them(folder: Folder) -> None:
    arm = robot(*ARM)
    line = refused(folder, arm, "--type", "trajectory", "--type", "position")
    assert line.startswith(
        "'trajectory' and 'position' would command the same joints; name those of each: --controller"
    )
    line = refused(folder, arm, "--controller", "a=trajectory:.*", "--controller", "b=position")
    assert line.startswith("'b': no joint remains for it; name its joints: --controller b=position:REGEX")
    words = ("--controller", "a=trajectory:.*", "--controller", "b=position:elbow", "--package", "p")
    folder.write({"r.urdf": arm})
    for form in ("python", "xml", "yaml"):
        launch = command("gen-launch", "r.urdf", "--distro", "jazzy", "--form", form, *words).stdout
        assert launch.count("--inactive") == 1
    launch = command("gen-launch", "r.urdf", "--distro", "noetic", *words).stdout
    assert 'args="--stopped b"' in launch


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (("arm",), "'arm' is not a controller: write --controller NAME=TYPE or NAME=TYPE[INTERFACE]:JOINTS"),
        (("a=trajectory[]:elbow",), "'a=trajectory[]:elbow' is not a controller: write --controller NAME=TYPE or"),
        (("a=trajectory[effort:elbow",), "'a=trajectory[effort:elbow' is not a controller: write --controller"),
        (("a=gripper[velocity]:finger",), "no 'gripper' controller commands 'velocity' in jazzy; choose from: pos"),
        (("a=trajectroy",), "unknown type 'trajectroy'; did you mean 'trajectory'?"),
        (("a b=trajectory",), "'a b' cannot be a controller's name: use letters, digits and underscores"),
        (("a=trajectory:elbw",), "controller 'a': no joint matches 'elbw'; did you mean 'elbow'?"),
        (("a=gripper:finger_2",), "joint 'finger_2' mimics 'finger'; command that joint in 'a'"),
        (("a=trajectory:(",), "'(' is not a valid regular expression"),
        (
            ("a=trajectory:elbow", "a=position:wrist"),
            "two controllers are called 'a'; give each --controller its own name",
        ),
    ],
)
def test_a_wrong_request_is_refused_in_one_line(words: tuple[str, ...], line: str, folder: Folder) -> None:
    options = [word for text in words for word in ("--controller", text)]
    assert refused(folder, robot(*ARM, *HAND), *options).startswith(line)


def test_a_list_says_which_controller_has_which_joint(folder: Folder) -> None:
    folder.write(
        {
            "r.urdf": robot(*ARM, *HAND),
            "joints.csv": "name,controller,type\nshoulder,arm,trajectory\nelbow,arm,trajectory\nfinger,hand,gripper\n",
        }
    )
    plain = read(command("gen-controllers", "r.urdf", "joints.csv", "--distro", "jazzy").stdout)
    assert plain["arm"]["ros__parameters"]["joints"] == ["shoulder", "elbow"]
    assert plain["hand"]["ros__parameters"]["joint"] == "finger"
    folder.write({"joints.csv": "name,controller\nshoulder,arm\n"})
    ran = command("gen-controllers", "r.urdf", "joints.csv", "--distro", "jazzy")
    assert ran.stderr == "urdfctl: controller 'arm' has no type: add a column `controller_type`, or --type\n"


PROPOSALS = {
    "arm": (ARM, "arm_controller=trajectory:shoulder,elbow,wrist"),
    "an arm whose first joint pans": (
        (joint("shoulder_pan", "base"), joint("lift", "shoulder_pan_link"), joint("elbow", "lift_link")),
        "arm_controller=trajectory:shoulder_pan,lift,elbow",
    ),
    "an arm whose first joint is a torso": (
        (
            joint("torso", "base", kind="prismatic"),
            joint("m1", "torso_link"),
            joint("m2", "m1_link"),
            joint("m3", "m2_link"),
            joint("m4", "m3_link"),
        ),
        "arm_controller=trajectory:torso,m1,m2,m3,m4",
    ),
    "a torso with a pan": (
        (joint("torso", "base", kind="prismatic"), joint("m1", "torso_link")),
        "torso_controller=trajectory:torso,m1",
    ),
    "a long neck": (
        (
            joint("neck1", "base"),
            joint("neck2", "neck1_link"),
            joint("neck3", "neck2_link"),
            joint("yaw", "neck3_link"),
            joint("nod", "yaw_link"),
        ),
        "head_controller=trajectory:neck1,neck2,neck3,yaw,nod",
    ),
    "a leg with a shoulder": (
        (joint("haa", "base"), joint("hfe", "haa_link"), joint("shoulder_leg", "hfe_link")),
        "leg_controller=trajectory:haa,hfe,shoulder_leg",
    ),
    "arm and gripper": (
        (*ARM, *HAND),
        "arm_controller=trajectory:shoulder,elbow,wrist --controller gripper_controller=gripper:finger",
    ),
    "two wheels and a caster": ((*WHEELS, *CASTER), "base_controller=diff_drive:left_wheel,right_wheel"),
    "four wheels": (FOUR, "base_controller=diff_drive:f_l,f_r,r_l,r_r"),
    "a rover with rockers": (
        (
            joint("left_rocker", "base", at="0 0.2 0"),
            wheel("left_wheel_1", 0.2, 0, "left_rocker_link"),
            wheel("left_wheel_2", -0.2, 0, "left_rocker_link"),
            joint("right_rocker", "base", at="0 -0.2 0"),
            wheel("right_wheel_1", 0.2, 0, "right_rocker_link"),
            wheel("right_wheel_2", -0.2, 0, "right_rocker_link"),
        ),
        "base_controller=diff_drive:left_wheel_1,left_wheel_2,right_wheel_1,right_wheel_2",
    ),
    "four mecanum wheels": (
        tuple(part.replace("_link", "_mecanum") for part in FOUR),
        "base_controller=mecanum:f_l,f_r,r_l,r_r",
    ),
    "a car": (CAR, "base_controller=ackermann:rear_left,rear_right,steer_left,steer_right"),
    "mobile manipulator": (
        (*WHEELS, *ARM),
        "base_controller=diff_drive:left_wheel,right_wheel --controller arm_controller=trajectory:shoulder,elbow,wrist",
    ),
    "two arms": (
        tuple(re.sub('"(shoulder|elbow|wrist)', rf'"{side}_\1', part) for side in ("left", "right") for part in ARM),
        " --controller ".join(
            f"{side}_arm_controller=trajectory:{side}_shoulder,{side}_elbow,{side}_wrist" for side in ("left", "right")
        ),
    ),
    "a humanoid in camel case": (
        tuple(
            part
            for side in ("L", "R")
            for part in (
                joint(f"{side}HipYaw", "base"),
                joint(f"{side}HipPitch", f"{side}HipYaw_link"),
                joint(f"{side}KneePitch", f"{side}HipPitch_link"),
            )
        ),
        (
            "left_leg_controller=trajectory:LHipYaw,LHipPitch,LKneePitch --controller "
            "right_leg_controller=trajectory:RHipYaw,RHipPitch,RKneePitch"
        ),
    ),
    "four legs without a word for them": (
        tuple(
            part
            for side in ("lf", "rf", "lb", "rb")
            for part in (
                joint(f"base_{side}1", "base"),
                joint(f"{side}1_{side}2", f"base_{side}1_link"),
                joint(f"{side}2_{side}3", f"{side}1_{side}2_link"),
            )
        ),
        " --controller ".join(
            f"{name}_leg_controller=trajectory:base_{side}1,{side}1_{side}2,{side}2_{side}3"
            for side, name in (("lf", "front_left"), ("rf", "front_right"), ("lb", "rear_left"), ("rb", "rear_right"))
        ),
    ),
    "a head": (
        (joint("HeadYaw", "base"), joint("HeadPitch", "HeadYaw_link")),
        "head_controller=trajectory:HeadYaw,HeadPitch",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PROPOSALS)
def test_controllers_are_proposed_for_all_parts_of_a_robot(name: str, folder: Folder) -> None:
    parts, proposal = PROPOSALS[name]
    folder.write({"r.urdf": robot(*parts)})
    ran = command("gen-controllers", "r.urdf", "--distro", "jazzy")
    assert (ran.returncode, ran.stderr) == (
        0,
        f"urdfctl: controllers proposed from the robot: --controller {proposal}\n",
    )
    again = command("gen-controllers", "r.urdf", "--distro", "jazzy", "--controller", *proposal.split())
    assert again.stdout.splitlines()[1:] == ran.stdout.splitlines()[1:]


def test_sensors_and_gpios_get_broadcasters(folder: Folder) -> None:
    part = """<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <sensor name="imu"><state_interface name="angular_velocity.x"/></sensor>
      <sensor name="wrist_ft"><state_interface name="force.x"/></sensor>
      <gpio name="valve"><command_interface name="open"/></gpio></ros2_control>
      <gazebo reference="base"><sensor name="imu" type="imu"/></gazebo>"""
    found = written(folder, robot(part))
    assert found["imu_broadcaster"]["frame_id"] == "base"
    assert found["wrist_ft_broadcaster"]["sensor_name"] == "wrist_ft"
    assert found["gpio_controller"]["gpios"] == ["valve"]
    full = written(folder, robot(part), "--type", "gpio_controllers/GpioCommandController")
    assert full["gpio_controller"]["command_interfaces"] == {"valve": {"interfaces": ["open"]}}


def test_what_is_proposed_fits_the_interfaces_that_the_robot_has(folder: Folder) -> None:
    transmissions = "".join(
        f"""<transmission name="{side}"><type>transmission_interface/SimpleTransmission</type>
        <joint name="{side}_wheel">
        <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
        <actuator name="{side}_motor"/></transmission>"""
        for side in ("left", "right")
    )
    found = written(folder, robot(*WHEELS, transmissions), distro="noetic")
    assert [one["type"] for one in found.values()] == ["effort_controllers/JointVelocityController"] * 2
    parts = "".join(
        f'<joint name="{side}_wheel"><command_interface name="effort"/></joint>' for side in ("left", "right")
    )
    component = f"""<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
        </hardware>{parts}</ros2_control>"""
    assert written(folder, robot(*WHEELS, component))["wheel_controller"]["interface_name"] == "effort"


@pytest.mark.parametrize(
    ("velocity", "expected"), [('<state_interface name="velocity"/>', "parallel_gripper"), ("", "joint_trajectory")]
)
def test_a_finger_that_offers_no_velocity_gets_a_controller_that_reads_none(
    velocity: str, expected: str, folder: Folder
) -> None:
    states = f'<command_interface name="position"/><state_interface name="position"/>{velocity}'
    component = f"""<ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
        </hardware><joint name="finger">{states}</joint></ros2_control>"""
    found = written(folder, robot(*ARM, HAND[0], component))
    assert found["gripper_controller"]["type"].startswith(expected)


def test_casters_alone_get_no_controller(folder: Folder) -> None:
    casters = [part.replace("caster", "front_caster").replace("swivel", "front_swivel") for part in CASTER]
    folder.write({"r.urdf": robot(*ARM, *CASTER, *casters)})
    line = command("gen-controllers", "r.urdf", "--distro", "jazzy").stderr
    assert line.endswith("robot: --controller arm_controller=trajectory:shoulder,elbow,wrist\n")


def test_the_fingers_of_two_arms_get_two_grippers(folder: Folder) -> None:
    arms = [
        re.sub('"(shoulder|elbow|wrist|finger)', rf'"{side}_\1', part)
        for side in ("l", "r")
        for part in (*ARM, HAND[0])
    ]
    found = written(folder, robot(*arms))
    assert [one["joint"] for one in found.values() if "gripper" in one["type"]] == ["l_finger", "r_finger"]


def cart(shape: str, turn: str = "0 0 0", called: str = "wheel") -> str:
    """Two wheels whose shapes are 0.02 m farther out than their joints."""
    parts = []
    for side, sign in (("left", 1), ("right", -1)):
        place = f'<collision><origin xyz="0 {0.02 * sign} 0" rpy="{turn}"/><geometry>{shape}</geometry></collision>'
        part = joint(f"{side}_{called}", "base", kind="continuous", at=f"0 {0.2 * sign} 0")
        parts.append(part.replace("</inertial></link>", f"</inertial>{place}</link>"))
    return robot(*parts)


@pytest.mark.parametrize(
    ("shape", "called"),
    [
        ('<cylinder radius="0.1" length="0.04"/>', "wheel"),
        ('<mesh filename="w.stl" scale="2 1 2"/>', "wheel"),
        ('<mesh filename="rear_wheel.stl" scale="2 1 2"/>', "rear"),
    ],
)
def test_wheels_are_measured_where_they_touch_the_ground(shape: str, called: str, folder: Folder) -> None:
    corners = [(x, y, z) for x, z in ((0.05, 0), (0, 0.05), (-0.05, 0), (0, -0.05)) for y in (-0.01, 0.01)]
    faces = "".join(
        "facet normal 0 0 1 outer loop " + "".join(f"vertex {x} {y} {z} " for x, y, z in three) + "endloop endfacet "
        for three in (corners[:3], corners[3:6], corners[5:])
    )
    folder.write(dict.fromkeys(("w.stl", "rear_wheel.stl"), f"solid w {faces}endsolid w"))
    turn = "1.5707963 0 0" if "cylinder" in shape else "0 0 0"
    found = written(folder, cart(shape, turn, called), "--type", "diff_drive")["diff_drive_controller"]
    assert found["wheel_radius"] == pytest.approx(0.1)
    assert found["wheel_separation"] == pytest.approx(0.44)


def test_an_unclear_drive_is_asked_for(folder: Folder) -> None:
    line = refused(folder, robot(wheel("left_wheel", 0, 0.2), wheel("right_1", 0, -0.2), wheel("right_2", -1, -0.2)))
    assert line.startswith(
        "no controller can be proposed for the wheels (left_wheel, right_1, right_2): its drive is unclear"
    )
    line = refused(folder, robot(*(part.replace("_link", "_mecanum") for part in FOUR)), distro="noetic")
    assert "noetic has no controller for mecanum bases; use --controller NAME=TYPE" in line
