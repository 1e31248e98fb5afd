"""CMakeLists.txt of a package of ROS 1 without compiled code, after its migration."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import MANIFEST, migrated

from urdfctl.migrate.shared.install_rules import installs

WITHOUT_CATKIN = """\
cmake_minimum_required(VERSION 2.8.3)
project(arm)

find_package(gazebo REQUIRED)

catkin_package()

include_directories(
  ${catkin_INCLUDE_DIRS}
)

install(DIRECTORY urdf DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
"""
COMMENTED = """\
cmake_minimum_required(VERSION 3.0.2)
project(arm)
## if COMPONENTS list like find_package(catkin REQUIRED COMPONENTS xyz)
find_package(catkin REQUIRED COMPONENTS
  urdf
)
# catkin_package() is next, see ${CATKIN_PACKAGE_SHARE_DESTINATION}
catkin_package()  # exports nothing
"""
ROBOT = '<robot name="arm"><link name="base"/></robot>\n'


def test_ament_is_looked_for_where_catkin_was_not_and_gazebo_classic_no_longer(folder: Folder) -> None:
    after = migrated(folder, {"CMakeLists.txt": WITHOUT_CATKIN, "urdf/arm.urdf": ROBOT}, "--simulator", "gz")
    assert after["CMakeLists.txt"] == (
        "cmake_minimum_required(VERSION 3.8)\nproject(arm)\n\nfind_package(ament_cmake REQUIRED)\n\n"
        "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n\nament_package()\n"
    )


def test_a_build_file_that_is_one_of_ament_already_ends_once(folder: Folder) -> None:
    build = "project(arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    after = migrated(folder, {"CMakeLists.txt": build, "launch/a.launch": "<launch/>\n"})["CMakeLists.txt"]
    assert after.count("find_package(ament_cmake REQUIRED)") == 1
    assert after.endswith("install(DIRECTORY launch\n  DESTINATION share/${PROJECT_NAME}\n)\n\nament_package()\n")
    assert after.count("ament_package(") == 1


def test_comments_stay(folder: Folder) -> None:
    after = migrated(folder, {"CMakeLists.txt": COMMENTED})
    assert after["CMakeLists.txt"] == (
        "cmake_minimum_required(VERSION 3.8)\nproject(arm)\n"
        "## if COMPONENTS list like find_package(catkin REQUIRED COMPONENTS xyz)\n"
        "find_package(ament_cmake REQUIRED)\n"
        "# catkin_package() is next, see ${CATKIN_PACKAGE_SHARE_DESTINATION}\n\nament_package()\n"
    )


def test_a_package_that_is_needed_to_build_and_to_run_is_still_needed_to_run(folder: Folder) -> None:
    kinds = ("build_depend", "build_export_depend", "exec_depend")
    lines = "".join(f"  <{kind}>{name}</{kind}>\n" for name in ("rospy", "gazebo_ros") for kind in kinds)
    tool = "  <buildtool_depend>catkin</buildtool_depend>\n"
    text = f'<package format="2">\n  <name>arm</name>\n{tool}{lines}</package>\n'
    launch = '<launch>\n  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>\n</launch>\n'
    files = {"package.xml": text, "urdf/arm.urdf": ROBOT, "launch/arm.launch": launch}
    manifest = migrated(folder, files, "--simulator", "gz")["package.xml"]
    for name in ("rclpy", "ros_gz_sim", "ros_gz_bridge"):
        assert manifest.count(name) == manifest.count(f"<exec_depend>{name}</exec_depend>") == 1


def test_a_file_that_is_installed_and_does_not_exist_is_told(folder: Folder) -> None:
    programs = "scripts/there.py ${PROJECT_SOURCE_DIR}/scripts/gone.py  # scripts/old.py\n"
    rule = f"catkin_install_python(PROGRAMS {programs}  DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})\n"
    optional = "install(FILES notes.txt DESTINATION share OPTIONAL)\ninstall(FILES arm.launch DESTINATION share)\n"
    files = {"CMakeLists.txt": COMMENTED + rule + optional, "scripts/there.py": "", "urdf/arm.urdf": ROBOT}
    told = [line for line in migrated(folder, files)["MIGRATION.md"].splitlines() if "is to be installed" in line]
    assert [line.partition(",")[0] for line in told] == ["- `CMakeLists.txt`: 'scripts/gone.py' is to be installed"]


def test_tools_and_messages_of_ros_1_are_needed_no_longer(folder: Folder) -> None:
    names = ("rosbag", "roslib", "message_runtime", "rosparam", "std_msgs")
    needed = "".join(f"  <depend>{name}</depend>\n" for name in names)
    manifest = MANIFEST.replace("</package>", f"{needed}</package>")
    after = migrated(folder, {"package.xml": manifest, "urdf/arm.urdf": ROBOT})["package.xml"]
    assert [name for name in (*names, "rosbag2", "ament_index_python") if f"depend>{name}</" in after] == [
        "std_msgs",
        "rosbag2",
        "ament_index_python",
    ]


USED = """\
<launch>
  <arg name="robot" default="arm"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/robot/$(arg robot).urdf"/>
  <!-- <node pkg="rviz" type="rviz" name="rviz" required="true"/> -->
  <!--node pkg="rviz" type="rviz" name="rviz" required="true"/-->
  <node pkg="arm" type="servo" name="servo"/>
</launch>
"""


def test_the_programs_and_folders_that_files_use_are_installed(folder: Folder) -> None:
    programs = "install(PROGRAMS nodes/known.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
    script = "#!/usr/bin/env python3\n"
    files = {"CMakeLists.txt": COMMENTED + programs, "launch/arm.launch": USED, "robot/arm.urdf": ROBOT}
    names = ("nodes/servo", "nodes/known.py", "nodes/library.py", "setup.py", "test/tried.py")
    after = migrated(folder, {**files, **dict.fromkeys(names, script), "nodes/servo.txt": "servo"})
    assert after["CMakeLists.txt"].endswith(
        "install(DIRECTORY launch robot\n  DESTINATION share/${PROJECT_NAME}\n)\n\n"
        "install(PROGRAMS\n  nodes/servo\n  DESTINATION lib/${PROJECT_NAME}\n)\n\nament_package()\n"
    )
    assert "rviz" not in after["package.xml"]


def test_a_script_that_may_be_executed_is_installed_too(folder: Folder) -> None:
    for name in ("scripts/teleop.py", "cfg/Gains.cfg", "setup.py"):
        folder.write({f"arm/{name}": "#!/usr/bin/env python3\n"})
        (folder.path / "arm" / name).chmod(0o755)
    after = migrated(folder, {"CMakeLists.txt": COMMENTED, "urdf/arm.urdf": ROBOT})["CMakeLists.txt"]
    assert "install(PROGRAMS\n  scripts/teleop.py\n  DESTINATION" in after
    assert "Gains.cfg" not in after
    assert "setup.py" not in after


def test_commands_of_cmake_are_known_in_capitals(folder: Folder) -> None:
    compiled = "PROJECT(arm)\nFIND_PACKAGE(catkin REQUIRED)\nADD_EXECUTABLE(mover src/mover.cpp)\nCATKIN_PACKAGE()\n"
    after = migrated(folder, {"CMakeLists.txt": compiled, "urdf/arm.urdf": ROBOT})
    assert after["CMakeLists.txt"] == compiled
    assert "this package compiles code or messages" in after["MIGRATION.md"]
    other = compiled.replace("ADD_EXECUTABLE(mover src/mover.cpp)\n", "")
    after = migrated(folder, {"CMakeLists.txt": other, "urdf/arm.urdf": ROBOT})["CMakeLists.txt"]
    assert after.startswith("PROJECT(arm)\nfind_package(ament_cmake REQUIRED)\n\ninstall(DIRECTORY urdf")


LOOP = "foreach(dir {})\n  install(DIRECTORY ${{dir}}/ DESTINATION share/arm/${{dir}})\nendforeach()\n"


def test_a_loop_over_lists_that_are_set_installs_only_what_they_name(folder: Folder) -> None:
    lists = "set(LAUNCHES launch launch/config)\nset(ROBOTS urdf)\n"
    loop = LOOP.format("${LAUNCHES} ${ROBOTS}")
    cmake = f"project(arm)\nfind_package(catkin)\n{lists}{loop}catkin_package()\n"
    files = {"CMakeLists.txt": cmake, "launch/config/a.rviz": "", "config/a.yaml": "a: 1\n", "urdf/arm.urdf": ROBOT}
    assert "install(DIRECTORY config\n" in migrated(folder, files)["CMakeLists.txt"]


def test_lists_that_double_from_one_to_the_next_are_not_followed_without_end() -> None:
    doubled = "".join(f"set(v{number} ${{v{number - 1}}}${{v{number - 1}}})\n" for number in range(60, 0, -1))
    assert not installs(f"{doubled}set(v0 launch)\ninstall(DIRECTORY ${{v60}} DESTINATION share)\n", "launch")


def test_a_loop_over_a_list_that_is_not_known_may_install_all(folder: Folder) -> None:
    cmake = f"project(arm)\nfind_package(catkin)\n{LOOP.format('${FOLDERS}')}catkin_package()\n"
    build = migrated(folder, {"CMakeLists.txt": cmake, "config/a.yaml": "a: 1\n", "urdf/arm.urdf": ROBOT})
    assert "DIRECTORY config" not in build["CMakeLists.txt"]


def test_meshes_that_are_installed_among_the_headers_are_installed_for_robots_too(folder: Folder) -> None:
    rule = "install(DIRECTORY {} DESTINATION ${{CATKIN_PACKAGE_{}_DESTINATION}})\n"
    build = COMMENTED + rule.format("meshes", "INCLUDE") + rule.format("launch", "SHARE")
    files = {"meshes/arm.stl": "solid", "launch/arm.launch": "<launch/>", "urdf/arm.urdf": ROBOT}
    after = migrated(folder, {"CMakeLists.txt": build, **files})["CMakeLists.txt"]
    assert "install(DIRECTORY meshes urdf\n  DESTINATION share/${PROJECT_NAME}\n)" in after


def test_a_package_that_only_a_broken_launch_file_names_is_not_needed(folder: Folder) -> None:
    node = '<node pkg="{}" type="a" name="a"/>'
    files = {
        "launch/arm.launch": f"<launch>{node.format('camera_of_arm')}</launch>",
        "launch/old.launch.xml": f"<launch><group>{node.format('lost_of_arm')}</launch>",
        "launch/new.launch.py": 'Node(package="also_lost", executable="a"\n',
    }
    after = migrated(folder, {"urdf/arm.urdf": ROBOT, **files})["package.xml"]
    assert "camera_of_arm" in after
    assert "lost" not in after


def test_tests_of_catkin_run_no_longer_and_are_left_to_a_person(folder: Folder) -> None:
    tests = "find_package(rostest REQUIRED)\nif(CATKIN_ENABLE_TESTING)\n  add_rostest(test/arm.test)\nendif()\n"
    after = migrated(folder, {"CMakeLists.txt": COMMENTED + tests, "urdf/arm.urdf": ROBOT})
    assert "rostest" not in after["CMakeLists.txt"]
    assert "BUILD_TESTING" not in after["CMakeLists.txt"]
    assert "tests of add_rostest no longer run" in after["MIGRATION.md"]


def test_tests_of_cmake_itself_stay(folder: Folder) -> None:
    tests = "if(CATKIN_ENABLE_TESTING)\n  add_test(NAME arm COMMAND arm)\nendif()\n"
    after = migrated(folder, {"CMakeLists.txt": COMMENTED + tests, "urdf/arm.urdf": ROBOT})
    assert "if(BUILD_TESTING)\n  add_test(NAME arm COMMAND arm)\nendif()\n" in after["CMakeLists.txt"]
    assert "no longer run" not in after["MIGRATION.md"]


def test_programs_are_installed_where_launch_finds_them(folder: Folder) -> None:
    rule = "install(PROGRAMS ros/src/servo.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}/ros/src)\n"
    files = {"CMakeLists.txt": COMMENTED + rule, "urdf/arm.urdf": ROBOT, "ros/src/servo.py": "#!/usr/bin/env python3\n"}
    after = migrated(folder, files)["CMakeLists.txt"]
    assert "install(PROGRAMS ros/src/servo.py DESTINATION lib/${PROJECT_NAME})\n" in after


def test_the_modules_of_a_package_are_still_installed(folder: Folder) -> None:
    setup = "setup(**generate_distutils_setup(packages=['arm_driver'], package_dir={'': 'src'}))\n"
    files = {"CMakeLists.txt": f"{COMMENTED}catkin_python_setup()\n", "urdf/arm.urdf": ROBOT, "setup.py": setup}
    after = migrated(folder, {**files, "src/arm_driver/__init__.py": ""})
    assert after["CMakeLists.txt"].endswith(
        "\nfind_package(ament_cmake_python REQUIRED)\n"
        "ament_python_install_package(arm_driver PACKAGE_DIR src/arm_driver)\n\nament_package()\n"
    )
    assert "setup.py installed" not in after["MIGRATION.md"]


def test_modules_that_are_not_found_are_left_to_a_person(folder: Folder) -> None:
    after = migrated(folder, {"CMakeLists.txt": f"{COMMENTED}catkin_python_setup()\n", "urdf/arm.urdf": ROBOT})
    assert "ament_python" not in after["CMakeLists.txt"]
    assert "setup.py installed the Python modules" in after["MIGRATION.md"]


def test_a_setup_file_that_names_no_module_of_the_package_leaves_nothing_to_do(folder: Folder) -> None:
    setup = "d = generate_distutils_setup()\nd['packages'] = ['arm_driver']\nsetup(**d)\n"
    files = {"CMakeLists.txt": f"{COMMENTED}catkin_python_setup()\n", "urdf/arm.urdf": ROBOT, "setup.py": setup}
    after = migrated(folder, {**files, "nodes/arm.py": "#!/usr/bin/env python3\n"})
    assert "catkin_python_setup" not in after["CMakeLists.txt"]
    assert "setup.py installed" not in after["MIGRATION.md"]
    (folder.path / "new").rename(folder.path / "first")
    after = migrated(folder, {**files, "nodes/arm_driver/__init__.py": ""})
    assert "setup.py installed" in after["MIGRATION.md"]


def test_headers_that_other_packages_include_are_still_exported(folder: Folder) -> None:
    build = COMMENTED.replace("catkin_package()  #", "catkin_package(INCLUDE_DIRS include)  #")
    after = migrated(folder, {"CMakeLists.txt": build, "urdf/arm.urdf": ROBOT, "include/arm/arm.h": ""})
    rule = "install(DIRECTORY include/\n  DESTINATION include\n)\nament_export_include_directories(include)\n"
    assert rule in after["CMakeLists.txt"]
    own = "install(DIRECTORY include/arm/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})\n"
    after = migrated(folder, {"CMakeLists.txt": build + own})["CMakeLists.txt"]
    assert after.count("DIRECTORY include") == after.count("ament_export_include_directories(include)") == 1
    after = migrated(folder, {"CMakeLists.txt": COMMENTED})["CMakeLists.txt"]
    assert "ament_export_include_directories" not in after


def test_a_dependency_that_ros_2_does_not_have_is_named(folder: Folder) -> None:
    needs = "<exec_depend>dynamic_reconfigure</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"
    manifest = MANIFEST.replace("</package>", f"  {needs}</package>")
    report = migrated(folder, {"package.xml": manifest, "urdf/arm.urdf": ROBOT})["MIGRATION.md"]
    assert "'dynamic_reconfigure' does not exist in ROS 2: use the parameters of a node in its place" in report
    assert "std_msgs" not in report


@pytest.mark.parametrize(
    ("imported", "installed"), [("import legs", True), ("from legs import *", True), ("import os", False)]
)
def test_the_modules_that_a_program_imports_from_its_folder_are_installed_beside_it(
    folder: Folder, imported: str, installed: bool
) -> None:
    launch = '<launch><node name="w" pkg="arm" type="walk.py"/></launch>\n'
    files = {
        "CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "launch/a.launch": launch,
        "scripts/walk.py": f"#!/usr/bin/env python\n{imported}\n",
        "scripts/legs.py": "from sizes import LENGTH\n",
        "scripts/sizes.py": "LENGTH = 1\n",
        "scripts/other.py": "WIDTH = 1\n",
    }
    build = migrated(folder, files)["CMakeLists.txt"]
    modules = "  scripts/legs.py\n  scripts/sizes.py\n" if installed else ""
    assert f"install(PROGRAMS\n  scripts/walk.py\n{modules}  DESTINATION lib/${{PROJECT_NAME}}\n)" in build


def test_packages_that_use_each_other_do_not_depend_on_each_other(folder: Folder) -> None:
    """colcon builds none of them otherwise."""
    other = MANIFEST.replace("<name>arm</name>", "<name>drive</name>")
    starts = '<launch><include file="$(find {})/launch/a.launch"/></launch>\n'
    files = {"arm/launch/a.launch": starts.format("drive"), "drive/launch/a.launch": starts.format("arm")}
    folder.write({"src/arm/package.xml": MANIFEST, "src/drive/package.xml": other})
    folder.write({f"src/{name}": text for name, text in files.items()})
    ran = folder.run("migrate", "src", "--from", "noetic", "--to", "jazzy", "-o", "new")
    assert ran.returncode == 0, ran.stderr
    names = ("arm/package.xml", "drive/package.xml", "MIGRATION.md")
    arm, drive, report = (folder.path.joinpath("new", name).read_text() for name in names)
    assert "<exec_depend>drive</exec_depend>" in arm
    assert "<exec_depend>arm</exec_depend>" not in drive
    assert "'arm' is used, but no dependency: it uses this package, too" in report


OF_XACRO = """\
project(arm)
find_package(catkin REQUIRED COMPONENTS xacro std_msgs)
catkin_package()
# catkin_add_env_hooks(arm) writes to ${CATKIN_ENV_HOOK_WORKSPACE}
include_directories(include ${catkin_INCLUDE_DIRS})
function(std_logs_all)
endfunction()
std_logs_all()
"""


@pytest.mark.parametrize("calls", [True, False])
def test_what_only_catkin_defines_and_a_build_file_still_names_is_told(folder: Folder, calls: bool) -> None:
    made = "xacro_add_xacro_file(a.xacro ${CATKIN_DEVEL_PREFIX}/share/arm/a.urdf)\n" if calls else ""
    report = migrated(folder, {"CMakeLists.txt": OF_XACRO + made, "urdf/arm.urdf": ROBOT})["MIGRATION.md"]
    assert ("'xacro_add_xacro_file()' came with find_package(catkin)" in report) == calls
    assert ("'CATKIN_DEVEL_PREFIX' is empty without catkin" in report) == calls
    assert "came with" not in report.replace("'xacro_add_xacro_file()' came with", "")
    assert "empty without" not in report.replace("'CATKIN_DEVEL_PREFIX' is empty without", "")
