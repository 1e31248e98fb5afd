"""Controllers, hardware and parameters that the workspace's packages define are known."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

import pytest
from folder import Folder
from robots import findings

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.definitions import definition_of
from urdfctl.catalog.reading import read_parameters
from urdfctl.load.target import Target
from urdfctl.source.disk.files import Files
from urdfctl.source.span import SourceText
from urdfctl.source.workspaces.plugin_exports import ExportedClass, exported_classes
from urdfctl.source.yaml.tree import read_yaml


def parameters(text: str) -> dict[str, Any]:
    found = definition_of(read_yaml(SourceText("x.yaml", text.encode())))
    return {} if found is None else dict(found.parameters)


def test_a_definition_is_read_with_types_defaults_and_validators() -> None:
    text = """
    arm_controller:
      joints: {type: string_array, default_value: [], read_only: true, validation: {unique<>: null, not_empty<>: []}}
      rate: {type: double, description: Hz, validation: {gt<>: [0.0], "own_package::even": null}}
      mode: {type: string, default_value: fast, validation: {one_of<>: [[fast, slow]]}}
      share: {type: double, default_value: 0.5, validation: {bounds<>: [0.0, 1.0]}}
      count: {type: int, default_value: 1, validation: {gt_eq: 1}}
      point: {type: double_array_fixed_3, default_value: [0.0, 0.0, 0.0]}
      gains:
        __map_joints:
          p: {type: double, default_value: 0.0}
      free: {type: none}
    """
    assert parameters(text) == {
        "joints": {"type": "string_array", "default": [], "validators": {"unique": True, "not_empty": True}},
        "rate": {"type": "double", "required": True, "validators": {"gt": 0.0}},
        "mode": {"type": "string", "default": "fast", "validators": {"one_of": ["fast", "slow"]}},
        "share": {"type": "double", "default": 0.5, "validators": {"bounds": [0.0, 1.0]}},
        "count": {"type": "int", "default": 1, "validators": {"gt_eq": 1}},
        "point": {"type": "double_array", "default": [0.0, 0.0, 0.0], "validators": {"size_lt": 4}},
        "gains.<joints>.p": {"type": "double", "default": 0.0},
        "free": {"type": "none"},
    }


@pytest.mark.parametrize(
    "text", ["", "- a", "a: 1", "a: {b: 1}", "a: {b: {type: pkg/Class}}", "a: {}\nb: {}", "a: {type: {type: 1}}", "{"]
)
def test_other_files_are_no_definition(text: str) -> None:
    assert parameters(text) == {}


def test_the_definition_of_a_known_controller_gives_the_parameters_of_the_catalogue() -> None:
    text = """
    passthrough_controller:
      interfaces:
        type: string_array
        description: "Names of the interfaces to command"
        default_value: []
        validation:
          not_empty<>: []
          unique<>: null
    """
    known = CATALOG.controller("passthrough_controller/PassthroughController", "jazzy")
    assert known is not None
    assert read_parameters(parameters(text), "jazzy") == dict(known.parameters)


@pytest.mark.parametrize("name", CATALOG.known_types("rolling"))
def test_a_definition_written_from_the_catalogue_is_read_as_the_catalogue(name: str) -> None:
    known = CATALOG.controller(name, "rolling")
    assert known is not None
    plain = {
        each: parameter
        for each, parameter in known.parameters.items()
        if len(parameter.types) == 1 and not parameter.required | bool(parameter.useful) | parameter.floats_only
    }
    tree: dict[str, Any] = {}
    for each, parameter in plain.items():
        node = tree
        for part in each.replace("<", "__map_").replace(">", "").split("."):
            node = node.setdefault(part, {})
        lists = {
            key: [value] if isinstance(value, list) and "of" in key else value
            for key, value in parameter.validators.items()
        }
        node |= {"type": parameter.type, "validation": {f"{key}<>": value for key, value in lists.items()}}
        if parameter.default is not None:
            node["default_value"] = parameter.default
    import yaml

    read = read_parameters(parameters(yaml.safe_dump({"x": tree})), "rolling") if tree else {}
    for each, parameter in plain.items():
        if parameter.default is not None:
            assert (read[each].type, repr(read[each].default)) == (parameter.type, repr(parameter.default))
            assert read[each].validators == parameter.validators


# -- packages ---------------------------------------------------------------------------------------------------------

MANIFEST = "<package format='3'><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
PLUGINS = """<library path="ours">
  <class name="our_controllers/ArmController" type="our_controllers::ArmController"
         base_class_type="controller_interface::ControllerInterface"/>
  <class name="our_controllers/LegController" type="our_controllers::LegController"
         base_class_type="controller_interface::ControllerInterface"/>
  <class name="our_controllers/ArmHardware" type="our_controllers::ArmHardware"
         base_class_type="hardware_interface::SystemInterface"/>
</library>"""
CMAKE = """project(our_controllers)
generate_parameter_library(arm_parameters src/arm.yaml)
pluginlib_export_plugin_description_file(controller_interface plugins/ours.xml)
"""
CODE = """#include "arm_parameters.hpp"
class ArmController : public controller_interface::ControllerInterface {}; // declare_parameter("x") is gone
"""
DEFINITION = """arm:
  joints: {type: string_array, validation: {not_empty<>: null}}
  speed: {type: double, default_value: 1.0, validation: {gt<>: [0.0]}}
"""
OURS = {
    ".git/HEAD": "",
    "ours/package.xml": MANIFEST.format("our_controllers"),
    "ours/CMakeLists.txt": CMAKE,
    "ours/plugins/ours.xml": PLUGINS,
    "ours/src/arm.yaml": DEFINITION,
    "ours/src/arm.cpp": CODE,
}


def controllers(kind: str, settings: str) -> str:
    return (
        f"controller_manager:\n  ros__parameters:\n    update_rate: 100\n    arm: {{type: {kind}}}\n"
        f"arm:\n  ros__parameters: {settings}\n"
    )


def said(folder: Folder, kind: str, settings: str, **changes: str) -> list[tuple[str, str, str]]:
    folder.write({**OURS, **{name.replace("__", "/"): text for name, text in changes.items()}})
    folder.write({"robot/package.xml": MANIFEST.format("robot"), "robot/c.yaml": controllers(kind, settings)})
    found = findings(Target("robot/c.yaml"), distro="jazzy")
    return [(one.severity.value, one.code, one.message) for one in found if one.code != "UC426"]


ARM = "our_controllers/ArmController"


@pytest.mark.parametrize(
    ("kind", "is_every_one_read"), [(ARM, False), ("our_controllers/Arm", True), ("theirs/ArmController", True)]
)
def test_only_the_package_that_a_type_is_named_after_is_read_if_it_has_the_type(
    folder: Folder, monkeypatch: pytest.MonkeyPatch, kind: str, *, is_every_one_read: bool
) -> None:
    read: list[str] = []

    def exported(path: str, files: Files) -> Iterator[ExportedClass]:
        read.append(os.path.basename(path))
        return exported_classes(path, files)

    monkeypatch.setattr("urdfctl.load.own_types.exported_classes", exported)
    said(folder, kind, "{joints: [a]}")
    assert ("robot" in read) == is_every_one_read


def test_a_controller_that_a_package_exports_is_checked_with_its_definition(folder: Folder) -> None:
    assert said(folder, ARM, "{joints: [a], speed: 2.0}") == []
    assert said(folder, ARM, "{joints: [a], speed: 0.0}") == [("error", "UC433", "'speed' must be > 0.0, not 0.0")]
    assert [one[:2] for one in said(folder, ARM, "{speed: 1.0}")] == [("error", "UC431")]
    assert [one[:2] for one in said(folder, ARM, "{joints: [a], speed: fast}")] == [("error", "UC432")]
    assert said(folder, ARM, "{joints: [a], other: 1}") == [
        ("warning", "UC430", "'arm' has no parameter 'other'; it is ignored")
    ]


@pytest.mark.parametrize(
    "code",
    [
        CODE + 'void f() { auto_declare<double>("other", 1.0); }',
        CODE.replace("controller_interface::ControllerInterface", "arm_base::Base"),
        '#include "arm_parameters.hpp"\nclass ArmController;',
    ],
)
def test_a_controller_that_may_read_more_is_checked_for_what_is_sure(folder: Folder, code: str) -> None:
    changed = {"ours/src/arm.cpp": code}
    assert said(folder, ARM, "{joints: [a], other: 1}", **changed) == []
    assert [one[1] for one in said(folder, ARM, "{joints: [a], speed: 0.0}", **changed)] == ["UC433"]


def test_parameters_without_a_definition_are_said_to_be_unchecked_once(folder: Folder) -> None:
    why = "package 'our_controllers' of this workspace does not define them as data"
    message = f"parameters of controller type 'our_controllers/LegController' are not checked: {why}"
    assert said(folder, "our_controllers/LegController", "{x: 1}") == [("info", "UC424", message)]
    prefixed = CODE + "auto x = std::make_shared<ParamListener>(get_node(), prefix);"
    assert [one[1] for one in said(folder, ARM, "{x: 1}", **{"ours/src/arm.cpp": prefixed})] == ["UC424"]


@pytest.mark.parametrize(("file", "is_read"), [("arm.yaml", True), ("gone.yaml", False)])
def test_the_definition_may_be_named_by_variables(folder: Folder, file: str, is_read: bool) -> None:
    cmake = f"""project(our_controllers)
        set(TARGET arm_parameters)
        set(SOURCE "src/{file}")
        generate_parameter_library(${{TARGET}} ${{SOURCE}})
        set(TARGET ours)
        pluginlib_export_plugin_description_file(controller_interface plugins/${{TARGET}}.xml)
    """
    found = said(folder, ARM, "{joints: [a], speed: 0.0}", **{"ours/CMakeLists.txt": cmake})
    assert [one[1] for one in found] == (["UC433"] if is_read else ["UC424"])


UPSTREAM = "battery_state_broadcaster/BatteryStateBroadcaster"


def workspace_with_upstreams_name(definition: str) -> dict[str, str]:
    """A package with the name and type of an upstream controller, and a definition of its own."""
    plugins = PLUGINS.replace("our_controllers", "battery_state_broadcaster").replace("Arm", "BatteryState")
    return {
        "ours/package.xml": MANIFEST.format("battery_state_broadcaster"),
        "ours/plugins/ours.xml": plugins.replace("BatteryStateController", "BatteryStateBroadcaster"),
        "ours/src/arm.yaml": definition,
        "ours/src/arm.cpp": CODE.replace("ArmController", "BatteryStateBroadcaster"),
    }


def test_an_own_controller_with_the_type_of_an_upstream_one_is_checked_with_its_own_definition(folder: Folder) -> None:
    other = workspace_with_upstreams_name("arm:\n  cells: {type: string_array}\n")
    assert said(folder, UPSTREAM, "{cells: [voltage]}", **other) == []
    assert [one[:2] for one in said(folder, UPSTREAM, "{batteries: [main]}", **other)] == [
        ("error", "UC431"),
        ("warning", "UC430"),
    ]


def test_a_copy_of_an_upstream_controller_is_checked_with_the_catalogue(folder: Folder) -> None:
    copy = workspace_with_upstreams_name("arm:\n  batteries: {type: string_array}\n  sensor_name: {type: string}\n")
    assert said(folder, UPSTREAM, "{batteries: [main]}", **copy) == []
    assert [one[1] for one in said(folder, UPSTREAM, "{batteries: [main], cells: [voltage]}", **copy)] == ["UC430"]


def test_a_misspelt_own_controller_is_an_error(folder: Folder) -> None:
    message = "controller type 'our_controllers/ArmControler' is unknown; did you mean 'our_controllers/ArmController'?"
    assert said(folder, "our_controllers/ArmControler", "{x: 1}") == [("error", "UC421", message)]


def test_an_own_package_without_the_class_is_taken_for_the_package_that_has_it(folder: Folder) -> None:
    right = "ur_controllers/ScaledJointTrajectoryController"
    ((_, code, message),) = said(folder, "our_controllers/ScaledJointTrajectoryController", "{x: 1}", **{
        "ours/plugins/ours.xml": PLUGINS.replace("ArmController", "JointTrajectoryController")
    })  # fmt: skip
    assert (code, message.partition("; ")[2]) == ("UC421", f"did you mean '{right}'?")


def test_a_type_that_resembles_a_known_one_is_right_if_a_package_exports_it(folder: Folder) -> None:
    own = PLUGINS.replace("our_controllers/ArmController", "joint_trajectory_controller/JointTrajectoryControler")
    kind = "joint_trajectory_controller/JointTrajectoryControler"
    assert said(folder, kind, "{joints: [a]}", **{"ours/plugins/ours.xml": own}) == []
    assert [one[1] for one in said(folder, kind, "{joints: [a]}")] == ["UC421"]


HARDWARE = """<robot name="r"><link name="a"/><ros2_control name="c" type="system">
<hardware><plugin>{}</plugin></hardware></ros2_control></robot>"""


@pytest.mark.parametrize("exported", ["manifest", "build file", "form"])
def test_hardware_that_a_package_exports_is_known_however_it_is_exported(folder: Folder, exported: str) -> None:
    kind = "mock_component/GenericSystem"
    robot = {".git/HEAD": "", "r/package.xml": MANIFEST.format("r"), "r/r.urdf": HARDWARE.format(kind)}
    folder.write(robot)
    assert [one.code for one in findings("r/r.urdf", ("UC353",), distro="jazzy")] == ["UC353"]
    plugins = PLUGINS.replace("our_controllers/ArmHardware", kind)
    manifest = MANIFEST.format("ours")
    export = "<export><hardware_interface plugin='${prefix}/p/ours.xml'/></export></package>"
    by = {
        "manifest": {"o/package.xml": manifest.replace("</package>", export), "o/p/ours.xml": plugins},
        "build file": {
            "o/package.xml": manifest,
            "o/CMakeLists.txt": "pluginlib_export_plugin_description_file(hardware_interface p/ours.xml)",
            "o/p/ours.xml": plugins,
        },
        "form": {"o/package.xml": manifest, "o/ours.xml": plugins},
    }
    folder.write(by[exported])
    assert findings("r/r.urdf", ("UC353",), distro="jazzy") == []


@pytest.mark.parametrize("name", ["our_controllers/ArmHardwar", "our_controller/ArmHardware"])
def test_misspelt_own_hardware_is_an_error(name: str, folder: Folder) -> None:
    folder.write({**OURS, "r/package.xml": MANIFEST.format("r"), "r/r.urdf": HARDWARE.format(name)})
    [found] = findings("r/r.urdf", ("UC353",), distro="jazzy")
    assert "did you mean 'our_controllers/ArmHardware'?" in found.message


@pytest.mark.parametrize(("dependency", "severities"), [("rclcpp", ["warning"]), ("arm_driver", [])])
def test_own_hardware_of_another_package_is_a_warning(dependency: str, severities: list[str], folder: Folder) -> None:
    launch = """
        <launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
        <param name="robot_description" value="$(command 'xacro $(find-pkg-share r)/r.urdf')" type="str"/>
        </node></launch>
    """
    manifest = MANIFEST.format("r").replace("</package>", f"<exec_depend>{dependency}</exec_depend></package>")
    robot = {"r/package.xml": manifest, "r/r.urdf": HARDWARE.format("arm_driver/ArmHardware"), "r/r.launch.xml": launch}
    folder.write({**OURS, **robot})
    assert [one.severity.value for one in findings("r/r.launch.xml", ("UC353",), distro="jazzy")] == severities


SIMULATED = """<robot name="r"><link name="a"/><gazebo><plugin name="p" filename="libgazebo_ros_control.so">
<robotSimType>{0}</robotSimType></plugin></gazebo></robot>"""
SIMULATION = (
    '<library path="o"><class name="{0}" type="o::Sim" base_class_type="gazebo_ros_control::RobotHWSim"/></library>'
)


def test_a_simulation_of_ros1_that_a_package_exports_is_known(folder: Folder) -> None:
    kind = "gazebo_ros_control/DefaultRobotHWSm"
    folder.write({".git/HEAD": "", "r/package.xml": MANIFEST.format("r"), "r/r.urdf": SIMULATED.format(kind)})
    assert [one.code for one in findings("r/r.urdf", ("UC526",), distro="noetic")] == ["UC526"]
    folder.write({"o/package.xml": MANIFEST.format("o"), "o/plugins.xml": SIMULATION.format(kind)})
    assert findings("r/r.urdf", ("UC526",), distro="noetic") == []


COMMANDED = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<ros2_control name="c" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
<joint name="j"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control></robot>"""
OF_OURS = """controller_manager:
  ros__parameters: {arm: {type: our_controllers/ArmController}}
arm:
  ros__parameters: {joints: [%s]}
"""
DESCRIBED = (
    '[[controllers]]\ntype = "our_controllers/ArmController"\n'
    'claims.command = [{ for_each = "joints", interface = "position" }]\n'
    'parameters.joints = { type = "string_array", required = true }\n'
)


@pytest.mark.parametrize(("described", "is_known"), [("", False), (DESCRIBED, True)])
def test_a_type_of_the_workspace_claims_what_the_configuration_says(
    folder: Folder, described: str, is_known: bool
) -> None:
    robot = {"r/package.xml": MANIFEST.format("r"), "r/r.urdf": COMMANDED, "r/c.yaml": OF_OURS % "nothing"}
    folder.write({**OURS, **robot, "urdfctl.toml": described})
    words = ("r/r.urdf", "--controllers", "r/c.yaml", "--distro", "jazzy", "--engine", "none")
    assert ("'nothing/position'" in folder.run("smoke", *words).stdout) is is_known
