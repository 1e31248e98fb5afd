"""Families of messages: each line of our own is explained by its message, with the cause that it is about."""

from __future__ import annotations

import pytest

from urdfctl.logs.digest import digest

FAMILIES = {
    # MoveIt
    "[ERROR] [1.0]: Action client not connected: arm_controller/follow_joint_trajectory": "moveit-action-not-connected",
    "[ERROR] [1.0] [x]: Action client not connected to action server: hand/gripper_cmd": "moveit-action-not-connected",
    "[ WARN] [1.0]: Waiting for arm_controller/follow_joint_trajectory to come up...": "moveit-waits-for-action",
    "[WARN] [1] [x]: No kinematics plugins defined. Fill and load kinematics.yaml!": "moveit-kinematics-not-loaded",
    "[ERROR] [1.0]: Group 'both_arms' is not a chain": "moveit-group-not-a-chain",
    "[ERROR] [1.0]: Robot semantic description not found. Did you forget to define or remap '/a/robot_description_"
    "semantic'?": "moveit-semantic-description-not-found",
    "[ERROR] [1.0]: Semantic description is not specified for the same robot as the URDF": "srdf-of-other-robot",
    "[ERROR] [1.0]: Joint 'j9' declared as part of group 'arm' is not known to the URDF": "srdf-name-unknown",
    "[ERROR] [1.0] [x]: No acceleration limit was defined for joint j1! You have to define acceleration limits in the "
    "URDF or joint_limits.yaml": "moveit-no-acceleration-limit",
    "[FATAL] [1.0]: Exception while loading planner 'ompl_interface/OMPLPlaner': …": "moveit-planner-not-loaded",
    "[ERROR] [1.0]: Exception while loading planning adapter plugin 'default_planner_request_adapters/X': …": (
        "moveit-adapter-not-loaded"
    ),
    "[ERROR] [1.0]: Joint 'j' from the starting state is outside bounds by: [3.3 ]": "moveit-start-state-out-of-bounds",
    "[ERROR] [1.0] [x]: Unknown joint in trajectory: j9": "moveit-joint-not-in-model",
    "[ INFO] [1.0]: Returned 0 controllers in list": "moveit-zero-controllers",
    "[ERROR] [1.0] [x]: Unable to connect to move_group action server 'move_action' within allotted time (30s)": (
        "moveit-no-move-group"
    ),
    # controllers at run time
    "[ERROR] [1.0] [a]: Joints on incoming trajectory don't match the controller joints.": "trajectory-joints-differ",
    "[WARN] [1.0] [a]: Aborted due to path tolerance violation": "trajectory-tolerance-violated",
    "[ERROR] [1.0]: Goal tolerances failed for joint: j2": "trajectory-tolerance-violated",
    "[ERROR] [1.0] [a]: Received trajectory with non-zero start time (1.0) that ends in the past (2.0)": (
        "trajectory-refused"
    ),
    "[WARN] [1.0] [cm]: Overrun might occur, Total time : 12000 us (Expected < 10000 us)": "control-loop-overrun",
    "[WARN] [1.0] [tf2_buffer]: Detected jump back in time. Clearing TF buffer.": "transform-out-of-time",
    "[ERROR] [1.0] [cm]: Resource conflict for controller 'a'. Command interface 'j1/position' is already claimed.": (
        "command-interface-claimed"
    ),
    "[WARN] [1.0] [cm]: The following controller with name 'pid' is not active and will not be activated.": (
        "following-controller-inactive"
    ),
    "[ERROR] [1.0] [c]: robot_description is empty": "controller-description-empty",
    # launch, build, plugins
    "ERROR: cannot launch node of type [arm_driver/node]: can't locate node [node] in package [arm_driver]": (
        "roslaunch-node-not-found"
    ),
    "Invalid roslaunch XML syntax: mismatched tag: line 3, column 2": "roslaunch-invalid-xml",
    "[ERROR] [launch]: Caught exception in launch (see debug for traceback): executed command failed. Command: xacro "
    "/a.xacro": "launch-command-failed",
    "TypeError: Node.__init__() got an unexpected keyword argument 'node_executable'": "launch-unexpected-keyword",
    "file INSTALL cannot find '/ws/src/arm/worlds'.": "symlink-install-folder-missing",
    "/opt/ros/humble/lib/x/node: symbol lookup error: /ws/install/lib/libx.so: undefined symbol: _ZN1xE": (
        "library-undefined-symbol"
    ),
    "what():  Could not find library corresponding to plugin arm/Hw. Make sure the plugin description XML file has the "
    "correct name of the library and that the library actually exists.": "plugin-library-not-found",
    "what():  MultiLibraryClassLoader: Could not create object of class type arm::Hw as no factory exists for it. Make "
    "sure that the library exists and was explicitly loaded through MultiLibraryClassLoader::loadLibrary()": (
        "plugin-not-exported"
    ),
    "[INFO] [b]: [ERROR] [launch]: Required launch argument 'model' was not provided": "launch-argument-not-given",
    # frames and models
    "No transform from [wheel_left] to [base_link]": "no-transform-to-frame",
    "Unable to find uri[model://my_robot/meshes/a.stl]": "model-uri-not-found",
    "Unable to download model[model://my_robot]": "model-uri-not-found",
    "[gz-1] Library [/opt/ros/humble/lib/libgz_ros2_control-system.so] does not export any plugins. The symbol "
    "[GzPluginHook] is missing, or it is not externally visible.": "library-of-other-simulator",
    "xacro: error: expected exactly one input file as argument": "xacro-not-one-file",
    "[ros2_control_node-2]   what():  Resource temporarily unavailable": "no-more-resources",
    "[create-3] [ERROR] [1.0] [x]: Must specify either -file, -param, -stdin or -topic": "spawner-without-model",
    "[create-3] [ERROR] [1.0] [ros_gz_sim]: Request to create entity from service [/world/empty/create] timed out..": (
        "spawn-service-missing"
    ),
    "[WARN] [1.0] [ros_gz_bridge]: Failed to create a bridge for topic [/scan] with ROS2 type "
    "[sensor_msgs/msg/LaserScan] to topic [/scan] with Gazebo Transport type [ignition.msgs.LaserScan]": (
        "bridge-not-created"
    ),
    "[rviz2-4] [INFO] [1.0] [rviz]: Message Filter dropping message: frame 'laser' at time 7.1 for reason 'discarding "
    "message because the queue is full'": "message-dropped-by-filter",
    "[move_group-1] [INFO] [1.0] [x]: Didn't receive robot state (joint angles) with recent timestamp within 1.000000 "
    "seconds.": "moveit-no-robot-state",
    "[rviz2-3] [ERROR] [1.0] [rviz2]: PluginlibFactory: The plugin for class 'moveit_rviz_plugin/MotionPlanning' "
    "failed to load. Error: x": "rviz-plugin-not-loaded",
    "[rviz2-3] qt.qpa.xcb: could not connect to display :0": "no-display",
}
"""A line, and the id of its message."""


@pytest.mark.parametrize("line", FAMILIES)
def test_a_line_of_each_family_is_explained_alone_and_in_a_long_log(line: str) -> None:
    log = ["[INFO] [1.0] [x]: hello"] * 50 + [line]
    for found in (digest([line], pasted=True), digest(log, pasted=False)):
        assert FAMILIES[line] in {known.message.id for known in found.known}


@pytest.mark.parametrize(
    "line",
    [
        "[INFO] [1] [x]: 'joints' or 'interfaces' parameter is empty. All available state interfaces will be published",
        "[ERROR] [1.0] [x]: No 3D sensor plugin(s) defined for octomap updates",
        "[ERROR] [1.0]: No p gain specified for pid.  Namespace: /gazebo_ros_control/pid_gains/j1",
        "[WARN] [1.0] [x]: Resolution not specified for Octomap. Assuming resolution = 0.1 instead",
        "[rviz2-4] [ERROR] [1.0] [x]: Action server: /recognize_objects not available",
        "[gz-1] [Wrn] [Component.hh:144] Trying to serialize component with data type [N3sdf3v135WorldE]",
        "[gzserver-2] [WARN] [1.0] [rcl]: Found remap rule '~/out:=odom'. This syntax is deprecated.",
    ],
)
def test_lines_that_look_bad_and_are_not_are_harmless(line: str) -> None:
    assert [known.kind for known in digest([line] * 50, pasted=False).known] == ["harmless"]


def test_a_process_that_rejects_its_arguments_is_told_which_option_wants_one_text() -> None:
    line = (
        "[ERROR] [spawner-6]: process has died [pid 7, exit code 2, cmd '/opt/ros/jazzy/lib/controller_manager/spawner "
        "base --controller-ros-args -r /base/odom:=/odom --ros-args']."
    )
    known = digest([line], pasted=True).known[0]
    assert "one text in quotes" in known.reading.causes[0].text
    assert "UC609" in known.rules


def test_an_empty_list_in_the_yaml_of_a_launch_file_is_named() -> None:
    line = (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Expected 'value' to be one of [<class "
        "'float'>, <class 'int'>], but got '()' of type '<class 'tuple'>'"
    )
    assert "empty list" in digest([line], pasted=True).known[0].reading.causes[0].text
