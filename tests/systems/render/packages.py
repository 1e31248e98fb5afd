"""What makes folders packages: manifests, and what is installed."""

from __future__ import annotations

from collections.abc import Iterable
from textwrap import dedent

from systems.system import System

_HEAD = '<?xml version="1.0"?>\n<package format="{format}">\n'


def package_files(
    system: System, package: str, paths: Iterable[str], depends: Iterable[str], *, build: str = "cmake"
) -> dict[str, str]:
    """Return what a package has beside its own files, by paths in the package.

    paths: of its own files.
    depends: the packages that it uses.
    build: "cmake" or "python".
    """
    folders = sorted({path.split("/")[0] for path in paths if "/" in path} - {package, "test"})
    module = any(path.startswith(f"{package}/") for path in paths)
    others = sorted(set(depends) - {package})
    if system.generation == 1:
        return {"package.xml": _manifest(package, "catkin", others, 2), "CMakeLists.txt": _catkin(package, folders)}
    if build == "python":
        return {
            "package.xml": _manifest(package, "ament_python", others, 3),
            "setup.py": _setup(package, folders),
            "setup.cfg": f"[develop]\nscript_dir=$base/lib/{package}\n[install]\ninstall_scripts=$base/lib/{package}\n",
            f"resource/{package}": "",
            f"{package}/__init__.py": "",
        }
    files = {
        "package.xml": _manifest(package, "ament_cmake", others, 3, module=module),
        "CMakeLists.txt": _ament_cmake(package, folders, module=module),
    }
    return {**files, f"{package}/__init__.py": ""} if module else files


def _manifest(package: str, build: str, depends: list[str], form: int, *, module: bool = False) -> str:
    lines = [
        f"<name>{package}</name>",
        "<version>0.1.0</version>",
        f"<description>{package.replace('_', ' ')}</description>",
        '<maintainer email="someone@example.org">Someone</maintainer>',
        "<license>MIT</license>",
    ]
    if build != "ament_python":
        lines.append(f"<buildtool_depend>{build}</buildtool_depend>")
    if module:
        lines.append("<buildtool_depend>ament_cmake_python</buildtool_depend>")
    lines += [f"<exec_depend>{name}</exec_depend>" for name in depends]
    if form == 3:
        lines.append(f"<export><build_type>{build}</build_type></export>")
    return _HEAD.format(format=form) + "".join(f"  {line}\n" for line in lines) + "</package>\n"


def _ament_cmake(package: str, folders: list[str], *, module: bool) -> str:
    lines = ["cmake_minimum_required(VERSION 3.8)", f"project({package})", "find_package(ament_cmake REQUIRED)"]
    if module:
        lines += ["find_package(ament_cmake_python REQUIRED)", "ament_python_install_package(${PROJECT_NAME})"]
    if folders:
        lines.append(f"install(DIRECTORY {' '.join(folders)} DESTINATION share/${{PROJECT_NAME}})")
    return "\n".join([*lines, "ament_package()", ""])


def _catkin(package: str, folders: list[str]) -> str:
    lines = ["cmake_minimum_required(VERSION 3.0.2)", f"project({package})", "find_package(catkin REQUIRED)"]
    lines.append("catkin_package()")
    if folders:
        where = "${CATKIN_PACKAGE_SHARE_DESTINATION}"
        lines += [f"install(DIRECTORY {name}/ DESTINATION {where}/{name})" for name in folders]
    return "\n".join([*lines, ""])


def _setup(package: str, folders: list[str]) -> str:
    data = "".join(f"        ('share/' + package_name + '/{name}', glob('{name}/*')),\n" for name in folders)
    head = dedent(f"""\
        from glob import glob

        from setuptools import setup

        package_name = '{package}'

        setup(
            name=package_name,
            version='0.1.0',
            packages=[package_name],
            data_files=[
                ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
                ('share/' + package_name, ['package.xml']),
        """)
    return f"{head}{data}    ],\n    install_requires=['setuptools'],\n    zip_safe=True,\n)\n"


def runtime_packages(system: System) -> list[str]:
    """Return the packages of what the descriptions and parameters name: hardware, simulators, controllers."""
    types = {"joint_trajectory_controller", "joint_state_broadcaster", "forward_command_controller"}
    if system.generation == 1:
        types = {"joint_trajectory_controller", "joint_state_controller"}
    types |= {"position_controllers", "velocity_controllers", "effort_controllers", "diff_drive_controller"}
    found = {*types, "controller_manager", "xacro", "robot_state_publisher"}
    if system.generation == 1:
        return sorted(found | ({"gazebo_ros", "gazebo_ros_control"} if system.is_simulated else set()))
    if system.simulator == "gz":
        return sorted(found | {"ign_ros2_control" if system.distro == "humble" else "gz_ros2_control", "ros_gz_sim"})
    if system.is_simulated:
        return sorted(found | {"gazebo_ros", "gazebo_ros2_control"})
    return sorted(found | {"hardware_interface"})
