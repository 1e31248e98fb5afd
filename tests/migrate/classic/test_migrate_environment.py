"""What a migration to gz makes of the places where the simulator looks for meshes, models and plugins."""

from __future__ import annotations

import pytest
from classic_packages import CONTROL, CONTROLLERS, DRIVE, MANIFEST, base, migrated
from folder import Folder

MESH = '  <link name="shell"><visual><geometry><mesh filename="package://base/meshes/shell.stl"/></geometry></visual></link>\n'
PARENT = '    <gazebo_ros gazebo_model_path="${prefix}/.."/>\n'


def after(folder: Folder, more: dict[str, str], gazebo: str = CONTROL) -> dict[str, str]:
    """The files of a package after its migration."""
    return migrated(folder, {"urdf/base.xacro": base(gazebo), "config/controllers.yaml": CONTROLLERS, **more})


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        (
            "hooks/base.dsv",
            "prepend-non-duplicate;GAZEBO_MODEL_PATH;share/base/models\n",
            "prepend-non-duplicate;GZ_SIM_RESOURCE_PATH;share/base/models\n",
        ),
        (
            "hooks/base.sh.in",
            "# for GAZEBO_PLUGIN_PATH\nexport GAZEBO_PLUGIN_PATH=@prefix@/lib:$GAZEBO_PLUGIN_PATH\n",
            "# for GAZEBO_PLUGIN_PATH\nexport GZ_SIM_SYSTEM_PLUGIN_PATH=@prefix@/lib:$GZ_SIM_SYSTEM_PLUGIN_PATH\n",
        ),
        (
            "launch/sim.launch.xml",
            '<launch>\n  <set_env name="GAZEBO_RESOURCE_PATH" value="/models"/>\n</launch>\n',
            '<launch>\n  <set_env name="GZ_SIM_RESOURCE_PATH" value="/models"/>\n</launch>\n',
        ),
        (
            "launch/paths.launch.py",
            "import os\n\nMY_GAZEBO_MODEL_PATH = os.environ['GAZEBO_MODEL_PATH']\n",
            "import os\n\nMY_GAZEBO_MODEL_PATH = os.environ.get('GZ_SIM_RESOURCE_PATH', \"\")\n",
        ),
        (
            "launch/set.launch.py",
            "import os\n\nos.environ['GAZEBO_MODEL_PATH'] = os.environ.get('GAZEBO_MODEL_PATH', '')\n",
            "import os\n\nos.environ['GZ_SIM_RESOURCE_PATH'] = os.environ.get('GZ_SIM_RESOURCE_PATH', '')\n",
        ),
        (
            "launch/variable.launch.py",
            "PATH = [EnvironmentVariable('GAZEBO_MODEL_PATH'), EnvironmentVariable('HOME')]\n",
            "PATH = [EnvironmentVariable('GZ_SIM_RESOURCE_PATH', default_value=\"\"), EnvironmentVariable('HOME')]\n",
        ),
        (
            "launch/exported.launch.py",
            "import os\nfrom scripts import GazeboRosPaths\n\nmodels, plugins, media = GazeboRosPaths.get_paths()\n",
            'import os\n\nmodels, plugins, media = ("", "", "")\n',
        ),
        (
            "launch/own.launch.py",
            "from scripts import paths\n\nmodels = paths.get_paths()\n",
            "from scripts import paths\n\nmodels = paths.get_paths()\n",
        ),
    ],
)
def test_the_environment_of_gazebo_classic_is_renamed(folder: Folder, name: str, old: str, new: str) -> None:
    assert after(folder, {name: old})[name] == new


def test_a_package_exports_its_meshes(folder: Folder) -> None:
    manifest = after(folder, {"meshes/shell.stl": "solid shell\nendsolid\n"}, MESH + CONTROL)["package.xml"]
    assert manifest.endswith(f"    <build_type>ament_cmake</build_type>\n{PARENT}  </export>\n</package>\n")


def test_a_package_exports_its_models(folder: Folder) -> None:
    manifest = after(folder, {"models/shelf/model.config": "<model/>\n"})["package.xml"]
    assert '    <gazebo_ros gazebo_model_path="${prefix}/models"/>\n  </export>' in manifest


def test_a_package_that_exports_another_folder_exports_its_meshes_too(folder: Folder) -> None:
    own = MANIFEST.replace("  </export>", f"{PARENT.replace('..', 'meshes')}  </export>")
    manifest = after(folder, {"package.xml": own, "meshes/shell.stl": "solid shell\nendsolid\n"})["package.xml"]
    assert manifest.count("gazebo_model_path") == 2
    assert PARENT in manifest


def test_a_manifest_without_exports_gets_them_for_its_models(folder: Folder) -> None:
    start, _, rest = MANIFEST.partition("  <export>")
    own = start + rest.partition("</export>\n")[2]
    manifest = after(folder, {"package.xml": own, "models/shelf/model.config": "<model/>\n"})["package.xml"]
    models = PARENT.replace("..", "models")
    assert manifest.endswith(f"  <export>\n{models}  </export>\n</package>\n")


def test_a_package_without_meshes_and_models_exports_nothing_more(folder: Folder) -> None:
    assert "gazebo_model_path" not in after(folder, {})["package.xml"]


@pytest.mark.parametrize(("path", "count"), [("other/..", 1), ("base/..", 0), ("base/models", 1), ("base/rviz", 1)])
def test_a_package_whose_path_is_set_exports_nothing(folder: Folder, path: str, count: int) -> None:
    text = f'<launch>\n  <set_env name="GZ_SIM_RESOURCE_PATH" value="/ws/{path}"/>\n</launch>\n'
    more = {"meshes/shell.stl": "solid shell\nendsolid\n", "launch/models.launch.xml": text}
    assert after(folder, more, MESH + CONTROL)["package.xml"].count("gazebo_model_path") == count


def test_an_export_is_not_repeated(folder: Folder) -> None:
    export = "    <build_type>ament_cmake</build_type>\n"
    own = MANIFEST.replace(export, export + PARENT)
    manifest = after(folder, {"package.xml": own, "meshes/shell.stl": "solid shell\nendsolid\n"})["package.xml"]
    assert manifest.count("gazebo_model_path") == 1


IN_GZ = """\
  <gazebo>
    <plugin filename="ign_ros2_control-system" name="ign_ros2_control::IgnitionROS2ControlPlugin">
      <parameters>$(find base)/config/controllers.yaml</parameters>
    </plugin>
  </gazebo>
  <gazebo reference="body"><sensor name="imu" type="imu"><topic>imu</topic></sensor></gazebo>
"""


def test_a_robot_that_is_simulated_in_gz_already_finds_its_meshes_and_sensors_as_before(folder: Folder) -> None:
    now = after(folder, {"meshes/shell.stl": ""}, MESH + IN_GZ)
    assert "gazebo_model_path" not in now["package.xml"]
    assert "gz-sim-imu-system" not in now["urdf/base.xacro"]
    assert "gz_ros2_control-system" in now["urdf/base.xacro"]


def test_a_package_in_gz_whose_name_has_gazebo_needs_nothing_instead_of_classic(folder: Folder) -> None:
    own = MANIFEST.replace("<name>base<", "<name>gazebo_base<")
    own = "".join(line for line in own.splitlines(keepends=True) if "exec_depend" not in line)
    launch = 'PACKAGE = "ros_gz_bridge"\n'
    world = '<sdf version="1.6"><world name="w"><plugin name="s" filename="libgazebo_ros_state.so"/></world></sdf>\n'
    more = {"package.xml": own, "launch/a.launch.py": launch, "w.sdf": world}
    now = after(folder, more, IN_GZ.replace("find base", "find gazebo_base"))
    assert "ros_gz_bridge" not in now["package.xml"]


IMU = '  <gazebo reference="body"><sensor name="imu" type="imu"><topic>imu</topic></sensor></gazebo>\n'
INCLUDE = '  <xacro:include filename="$(find vendor_description)/urdf/arm.xacro"/>\n'


@pytest.mark.parametrize("included", ["", INCLUDE])
def test_the_systems_of_a_robot_that_is_in_another_package_too_are_left_to_a_person(
    folder: Folder, included: str
) -> None:
    text = after(folder, {}, CONTROL + IMU + included)["urdf/base.xacro"]
    assert ("TODO(urdfctl): gz-sim-imu-system: load it in the world" in text) is bool(included)
    assert ('<plugin filename="gz-sim-imu-system"' in text) is not bool(included)


@pytest.mark.parametrize(
    ("model", "exported"),
    [
        ("shelves/shelf", "${prefix}/shelves"),
        ("shelf", "${prefix}"),
        ("models/wood/shelf", "${prefix}/models/wood"),
        ("shelves/other", None),
    ],
)
def test_a_package_exports_the_folder_in_which_its_worlds_find_models(
    folder: Folder, model: str, exported: str | None
) -> None:
    """Gazebo Classic had it in a variable that people set themselves, as GAZEBO_MODEL_PATH in ~/.bashrc."""
    world = '<sdf version="1.6"><world name="w"><include><uri>model://shelf</uri></include></world></sdf>\n'
    manifest = after(folder, {f"{model}/model.config": "<model/>\n", "worlds/w.world": world})["package.xml"]
    assert (f'gazebo_model_path="{exported}"/>' in manifest) == (exported is not None)
    assert ("gazebo_model_path" in manifest) == (exported is not None)


SPAWNS = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    robot = os.path.join(get_package_share_directory("{package}"), "urdf", "base.xacro")
    spawn = Node(package="gazebo_ros", executable="spawn_entity.py", arguments=["-entity", "base", "-file", robot])
    return LaunchDescription([ExecuteProcess(cmd=["gazebo"]), spawn])
"""


@pytest.mark.parametrize(("package", "is_here"), [("base", True), ("cart_description", False)])
def test_a_robot_whose_description_is_not_here_is_told(folder: Folder, package: str, is_here: bool) -> None:
    robot = {"urdf/base.xacro": base(DRIVE)} if is_here else {}
    report = migrated(folder, {**robot, "launch/sim.launch.py": SPAWNS.format(package=package)})["MIGRATION.md"]
    assert ("the robot is described in 'cart_description', not here" in report) != is_here
    assert "is described in 'base'" not in report
