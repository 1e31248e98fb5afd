"""The controllers that YAML files configure, in the shapes that ROS 1 and ROS 2 know."""

from __future__ import annotations

import pytest

from urdfctl.model.controllers import Controllers, FaultKind, ValueKind
from urdfctl.model.controllers.build_controllers import Loaded, controllers_of
from urdfctl.source.span import SourceText
from urdfctl.source.yaml.tree import read_yaml


def model(*texts: str, ros: int | None = None, started: tuple[str, ...] | None = None) -> Controllers:
    files = [read_yaml(SourceText(f"/{n}.yaml", text.encode())) for n, text in enumerate(texts)]
    return controllers_of(map(Loaded, files), ros, started)


def told(controllers: Controllers) -> list[tuple[str, str | None, str | None]]:
    return [(c.name, c.namespace, c.type.text if c.type else None) for c in controllers.controllers]


ROS2 = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
    base: {type: diff_drive_controller/DiffDriveController}
arm:
  ros__parameters:
    joints: [shoulder, elbow]
    gains:
      shoulder: {p: 1.0, d: 0}
    constraints.goal_time: 1e3
rosbag:
  ros__parameters: {x: 1}
"""


def test_ros_2_declares_controllers_under_the_manager() -> None:
    made = model(ROS2)
    assert made.files[0].form == 2
    assert told(made) == [
        ("arm", "", "joint_trajectory_controller/JointTrajectoryController"),
        ("base", "", "diff_drive_controller/DiffDriveController"),
    ]
    (manager,) = made.managers
    rate = manager.parameters.value("update_rate")
    assert (manager.name, manager.namespace, rate and rate.value) == ("controller_manager", "", 100)
    assert [section.path for section in made.others] == ["rosbag"]


def test_parameters_have_dotted_names_values_and_places() -> None:
    arm = model(ROS2).controller("arm")
    assert arm is not None
    assert arm.declared_at is not None
    assert arm.declared_at.span.text == "arm"
    gain = arm.parameters.get("gains.shoulder.d")
    assert gain is not None
    assert (gain.last, gain.key.span.text, gain.value.kind, gain.value.at.span.text) == ("d", "d", ValueKind.INT, "0")
    joints = arm.parameters.value("joints")
    assert joints is not None
    assert [(text, at.span.text) for text, at in joints.strings] == [("shoulder", "shoulder"), ("elbow", "elbow")]
    time = arm.parameters.value("constraints.goal_time")
    assert time is not None
    assert time.value == 1000.0
    assert [p.name for p in arm.parameters.below()] == ["joints", "gains", "constraints"]
    assert [p.name for p in arm.parameters.leaves] == [
        "joints",
        "gains.shoulder.p",
        "gains.shoulder.d",
        "constraints.goal_time",
    ]
    assert [p.name for p in arm.parameters.under("gains")] == ["shoulder", "shoulder.p", "shoulder.d"]


NODE = "{ros__parameters: {joints: [x]}}"


@pytest.mark.parametrize(
    ("key", "reaches"),
    [
        ("arm", True),
        ("/arm", True),
        ("/**/arm", True),
        ("/**", True),
        ("/*", True),
        ("/*/arm", False),
        ("robot/arm", False),
        ("/robot/arm", False),
        ("Arm", False),
    ],
)
def test_a_section_reaches_the_nodes_whose_full_name_it_matches(key: str, reaches: bool) -> None:
    made = model(f"controller_manager: {{ros__parameters: {{arm: {{type: a/B}}}}}}\n{key}: {NODE}\n")
    arm = made.controller("arm")
    assert arm is not None
    assert ("joints" in arm.parameters) is reaches
    assert ("joints" in arm.own) is (reaches and not key.endswith("*"))
    assert bool(made.others) is not reaches


@pytest.mark.parametrize(
    ("text", "namespace"),
    [
        ("/robot/controller_manager: {ros__parameters: {arm: {type: a/B}}}\n/robot/arm: " + NODE, "/robot"),
        ("robot:\n  controller_manager: {ros__parameters: {arm: {type: a/B}}}\n  arm: " + NODE, "/robot"),
        ("/**/controller_manager: {ros__parameters: {arm: {type: a/B}}}\n/**/arm: " + NODE, None),
        ("/**:\n  controller_manager: {ros__parameters: {arm: {type: a/B}}}\n  arm: " + NODE, None),
        ("/**: {ros__parameters: {arm: {type: a/B}, joints: [x]}}", None),
    ],
)
def test_namespaces_are_those_of_the_manager(text: str, namespace: str | None) -> None:
    made = model(text)
    assert told(made) == [("arm", namespace, "a/B")]
    assert "joints" in made.controllers[0].parameters
    assert made.others == ()


def test_a_type_in_the_controllers_own_section_counts() -> None:
    assert told(model("arm: {ros__parameters: {type: a/B, joints: [x]}}")) == [("arm", "", "a/B")]


def test_what_stands_under_the_manager_never_reaches_the_controller() -> None:
    text = "controller_manager: {ros__parameters: {arm: {type: a/B, params_file: f.yaml, joints: [x]}}}"
    arm = model(text).controller("arm")
    assert arm is not None
    assert [p.name for p in arm.under_manager] == ["joints"]
    assert [value.text for value in arm.parameter_files] == ["f.yaml"]
    assert "joints" not in arm.parameters


def test_of_several_files_the_later_wins_and_a_wildcard_too_if_it_comes_later() -> None:
    manager = "controller_manager: {ros__parameters: {arm: {type: a/B}}}\n"
    later = model(manager + "arm: {ros__parameters: {joints: [x], y: 1}}", "arm: {ros__parameters: {joints: [z]}}")
    arm = later.controller("arm")
    assert arm is not None
    assert [p.value.items and p.value.items[0].text for p in arm.parameters.leaves] == ["z", ()]
    wild = model(manager + "arm: {ros__parameters: {joints: [x]}}\n/**: {ros__parameters: {joints: [w]}}\n")
    joints = wild.controllers[0].parameters.value("joints")
    assert joints is not None
    assert joints.items[0].text == "w"


def test_a_controller_that_is_started_is_there_though_no_file_says_so() -> None:
    made = model(ROS2, started=("arm", "camera"))
    assert told(made)[2:] == [("camera", "", None)]
    assert made.controllers[2].declared_at is None


def test_a_declared_controller_without_a_type_has_none() -> None:
    text = "controller_manager: {ros__parameters: {arm: {typ: a/B}}}\narm: " + NODE
    assert told(model(text)) == [("arm", "", None)]


ROS1 = """\
robot:
  joint_state_controller: {type: joint_state_controller/JointStateController, publish_rate: 50}
  arm:
    type: effort_controllers/JointTrajectoryController
    joints: [shoulder]
    gains: {shoulder: {p: 1e3}}
  gazebo_ros_control:
    pid_gains: {elbow: {p: 1.0}}
"""


def test_ros_1_declares_controllers_by_their_type() -> None:
    made = model(ROS1)
    assert made.files[0].form == 1
    assert told(made) == [
        ("joint_state_controller", "/robot", "joint_state_controller/JointStateController"),
        ("arm", "/robot", "effort_controllers/JointTrajectoryController"),
    ]
    arm = made.controller("robot/arm")
    assert arm is not None
    gain = arm.parameters.value("gains.shoulder.p")
    assert gain is not None
    assert (gain.kind, gain.at.span.text) == (ValueKind.STRING, "1e3")
    gains = made.other("gazebo_ros_control")
    assert gains is not None
    assert (gains.namespace, "pid_gains.elbow.p" in gains.parameters) == ("/robot", True)


def test_ros_1_merges_keys_and_takes_the_last_of_a_key_given_twice() -> None:
    made = model("d: &d {type: a/B, joint: x}\nc: {<<: *d, joint: y}\nc: {<<: *d, rate: 1}\n", ros=1, started=("c",))
    c = made.controller("c")
    assert c is not None
    assert {p.name: p.value.text for p in c.parameters} == {"type": "a/B", "joint": "x", "rate": "1"}


def test_a_launch_files_namespace_stands_before_the_names() -> None:
    file = read_yaml(SourceText("/c.yaml", b"arm: {type: a/B}"))
    assert told(controllers_of([Loaded(file, "/robot")], 1)) == [("arm", "/robot", "a/B")]


def gains_of(gains: str) -> list[str]:
    """The parameters below `gains` of a controller in /robot whose joints have slashes."""
    text = f"arm: {{type: a/B, joints: [left/elbow, left/wrist], gains: {{{gains}}}}}"
    file = read_yaml(SourceText("/c.yaml", text.encode()))
    made = controllers_of([Loaded(file, "/robot")], 1).controller("/robot/arm")
    assert made is not None
    return [parameter.name for parameter in made.parameters if parameter.name.startswith("gains.")]


def test_the_slash_in_the_name_of_a_joint_is_that_between_the_namespaces_of_its_parameters() -> None:
    whole = ["gains.left/elbow", "gains.left/elbow.p", "gains.left/wrist", "gains.left/wrist.p"]
    assert gains_of("left/elbow: {p: 1}, left/wrist: {p: 1}") == whole
    assert gains_of("left: {elbow: {p: 1}, wrist: {p: 1}}") == whole
    assert gains_of("right/elbow: {p: 1}") == ["gains.right", "gains.right.elbow", "gains.right.elbow.p"]


def test_a_key_with_a_leading_slash_is_a_full_name_as_roslaunch_uploads_it() -> None:
    assert gains_of("/robot/arm/gains/left/elbow: {p: 1}") == ["gains.left/elbow", "gains.left/elbow.p"]
    assert gains_of("/other/arm/gains/left/elbow: {p: 1}") == []


@pytest.mark.parametrize(
    "text",
    [
        "controller_list:\n- {name: arm, type: FollowJointTrajectory, joints: [a]}\n",
        "moveit_simple_controller_manager:\n  controller_names: [arm]\n  arm: {type: FollowJointTrajectory}\n",
    ],
)
def test_lists_for_moveit_are_known_and_not_judged(text: str) -> None:
    made = model(text, ros=2)
    assert made.files[0].is_moveit
    assert (made.controllers, made.others, made.faults) == ((), (), ())


@pytest.mark.parametrize(
    ("text", "kind", "place"),
    [
        ("a: {ros__parameters: {x: &x [1], y: *x}}", FaultKind.ALIAS, "*x"),
        ("a: {ros__parameters: {x: }}", FaultKind.EMPTY, "x"),
        ("a: {ros__parameters: {x: {}}}", FaultKind.EMPTY_COLLECTION, "x"),
        ("a: {ros__parameters: {x: []}}", FaultKind.EMPTY_COLLECTION, "x"),
        ("a: {ros__parameters: {x: [a, yes]}}", FaultKind.MIXED_LIST, "yes"),
        ("a: {ros__parameters: {x: [1, 2.0]}}", FaultKind.MIXED_LIST, "2.0"),
        ("a: {ros__parameters: {x: [[1], [2]]}}", FaultKind.NESTED_LIST, "[1]"),
        ("a: {ros__parameters: {x: [{y: 1}, {z: 2}]}}", FaultKind.MAP_IN_LIST, "{z: 2}"),
        ("controller_manager: {update_rate: 1}", FaultKind.OUTSIDE_PARAMETERS, "update_rate"),
        ("a: {ros__parameters: [x]}", FaultKind.PARAMETERS_NOT_A_MAP, "ros__parameters"),
        ("arm/: {ros__parameters: {x: 1}}", FaultKind.NODE_NAME, "arm/"),
        ("/**arm: {ros__parameters: {x: 1}}", FaultKind.NODE_NAME, "/**arm"),
        ("ros__parameters: {x: 1}", FaultKind.NODE_NAME, "ros__parameters"),
    ],
)
def test_what_rcl_refuses_is_told_at_its_place(text: str, kind: FaultKind, place: str) -> None:
    (fault,) = model(text).faults
    assert (fault.kind, fault.at.span.text) == (kind, place)


@pytest.mark.parametrize(
    ("text", "kind", "place"),
    [
        ("c: {type: a/B, x: }", FaultKind.EMPTY, "x"),
        ("c: {type: a/B, x: [1, ~]}", FaultKind.EMPTY, "~"),
        ("c: {type: a/B, x: 4294967296}", FaultKind.OVERFLOW, "4294967296"),
        ("c: {type: a/B, x: 2024-01-01}", FaultKind.UNUSABLE, "2024-01-01"),
        ("c: {type: a/B, x: !mine 1}", FaultKind.UNUSABLE, "!mine 1"),
        ("c: {type: a/B, 1: 1}", FaultKind.KEY, "1"),
        ("c: {type: a/B}\n---\nd: 1\n", FaultKind.DOCUMENTS, "d: 1"),
    ],
)
def test_what_rosparam_refuses_is_told_at_its_place(text: str, kind: FaultKind, place: str) -> None:
    (fault,) = model(text).faults
    assert (fault.kind, fault.at.span.text) == (kind, place)


@pytest.mark.parametrize("ros", [1, 2])
def test_a_file_of_the_other_generation_gives_that_one_no_controllers(ros: int) -> None:
    made = model(ROS2 if ros == 1 else ROS1, ros=ros, started=("arm",))
    assert made.files[0].form == 3 - ros
    assert told(made) == [("arm", None, None)]


def test_a_file_that_is_no_yaml_leaves_nothing_to_be_called_absent() -> None:
    made = model("a: [", ROS2)
    assert not made.complete
    assert [file.readable for file in made.files] == [False, True]


@pytest.mark.parametrize("key", ['""', "/"])
def test_a_section_of_the_root_is_no_parameter_of_ros_1(key: str) -> None:
    text = f"{key}:\n  arm: {{type: position_controllers/JointTrajectoryController, joints: [a]}}\n"
    assert told(model(text, ros=1)) == [("arm", "", "position_controllers/JointTrajectoryController")]
