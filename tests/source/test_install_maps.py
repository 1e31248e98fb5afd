"""Install rules of CMakeLists.txt and setup.py say where the source of an installed path lies."""

# ruff: noqa: E501 (the rules are literal)
from __future__ import annotations

from pathlib import Path

import pytest

from urdfctl.source.disk.files import FileProblem, Files
from urdfctl.source.workspaces.install_maps import read_install_map

FILES = ["description/urdf/r.xacro", "config/c.yaml", "config/sub/d.yaml", "launch/l.py", "scripts/run", "top.xacro"]


def source(folder: Path, relative: str, *, cmake: str = "", setup: str = "") -> str | None:
    """The source of an installed path, relative to a package named arm."""
    for name in FILES:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).touch()
    (folder / "CMakeLists.txt").write_text(cmake)
    (folder / "setup.py").write_text(setup)
    found = read_install_map(str(folder), "arm").source_of(relative)
    return None if found is None else Path(found).relative_to(folder).as_posix()


@pytest.mark.parametrize(
    ("cmake", "relative", "expected"),
    [
        ("install(DIRECTORY description/urdf DESTINATION share/arm)", "urdf/r.xacro", "description/urdf/r.xacro"),
        ("install(DIRECTORY description/urdf/ DESTINATION share/arm)", "r.xacro", "description/urdf/r.xacro"),
        ("install(DIRECTORY description/urdf/ DESTINATION share/arm)", "urdf/r.xacro", None),
        ("install(DIRECTORY config/ DESTINATION share/arm/cfg)", "cfg/sub/d.yaml", "config/sub/d.yaml"),
        ("install(DIRECTORY launch config DESTINATION share/arm/all)", "all/config/c.yaml", "config/c.yaml"),
        ("install(FILES config/c.yaml top.xacro DESTINATION share/arm/x)", "x/c.yaml", "config/c.yaml"),
        ("install(FILES config/c.yaml DESTINATION share/arm)", "c.yaml", "config/c.yaml"),
        ("xacro_add_files(description/urdf/r.xacro TARGET t INSTALL DESTINATION urdf)", "urdf/r", "description/urdf/r.xacro"),
        ("xacro_add_files(description/urdf/r.xacro INSTALL)", "r", "description/urdf/r.xacro"),
        ("xacro_add_files(description/urdf/r.xacro TARGET t)", "r", None),
        ("xacro_add_files(description/urdf/r.xacro REMAP a:=b INSTALL DESTINATION urdf)", "urdf/r", None),
        ("install(PROGRAMS scripts/run DESTINATION share/arm/bin)", "bin/run", "scripts/run"),
        ("install(\n  DIRECTORY\n    description/urdf\n  DESTINATION\n    share/arm\n)", "urdf/r.xacro", "description/urdf/r.xacro"),
        ("INSTALL(DIRECTORY description/urdf DESTINATION share/arm)", "urdf/r.xacro", "description/urdf/r.xacro"),
        ("project(arm)\ninstall(DIRECTORY config DESTINATION share/${PROJECT_NAME}/a)", "a/config/c.yaml", "config/c.yaml"),
        ("project(arm)\ninstall(DIRECTORY config DESTINATION share/${CMAKE_PROJECT_NAME})", "config/c.yaml", "config/c.yaml"),
        ("install(DIRECTORY config DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION}/b)", "b/config/c.yaml", "config/c.yaml"),
        ("install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/config/ DESTINATION share/arm)", "c.yaml", "config/c.yaml"),
        ('install(DIRECTORY "config" DESTINATION "share/arm/a")', "a/config/c.yaml", "config/c.yaml"),
        ("install(DIRECTORY # all of it\n  config # and this\n  DESTINATION share/arm)", "config/c.yaml", "config/c.yaml"),
        ("# install(DIRECTORY config DESTINATION share/arm/old)", "old/config/c.yaml", None),
        ("install(DIRECTORY config DESTINATION share/arm/a PATTERN x EXCLUDE)", "a/config/c.yaml", "config/c.yaml"),
        ("install(DIRECTORY config DESTINATION lib/arm)", "config/d.yaml", None),
        ("install(TARGETS driver DESTINATION share/arm)", "driver", None),
        ("install(DIRECTORY config)", "config/none", None),
        ("install(DIRECTORY config DESTINATION share/arm/a)\ninstall(DIRECTORY launch DESTINATION share/arm/a)", "a/launch/l.py", "launch/l.py"),
        ("install(DIRECTORY config DESTINATION share/arm/a)", "a/config/none.yaml", None),
        ("install(DIRECTORY config DESTINATION share/arm/a)", "a", None),
        ("install(DIRECTORY config DESTINATION", "config", None),
        ("foreach(d launch config)\ninstall(DIRECTORY ${d}/ DESTINATION share/arm/x/${d})\nendforeach()", "x/config/c.yaml", "config/c.yaml"),
        ("set(all launch\n config)\nforeach(d IN LISTS all)\ninstall(DIRECTORY ${d} DESTINATION share/arm/x)\nendforeach(d)", "x/config/c.yaml", "config/c.yaml"),
        ("FOREACH(d IN ITEMS launch config)\ninstall(DIRECTORY ${d} DESTINATION share/arm/x)\nENDFOREACH()", "x/config/c.yaml", "config/c.yaml"),
        ("set(all launch config)\nforeach(d IN ITEMS ${all})\ninstall(DIRECTORY ${d} DESTINATION share/arm/x)\nendforeach()", "x/config/c.yaml", "config/c.yaml"),
        ("foreach(d IN ITEMS ${all})\ninstall(DIRECTORY ${d} DESTINATION share/arm/x)\nendforeach()", "x/config/c.yaml", None),
        ("ament_auto_package(USE_SCOPED_HEADER_INSTALL_DIR INSTALL_TO_SHARE launch description/urdf)", "urdf/r.xacro", "description/urdf/r.xacro"),
        ("foreach(d ${all})\ninstall(DIRECTORY ${d} DESTINATION share/arm/x)\nendforeach()", "x/config/c.yaml", None),
    ],
)  # fmt: skip
def test_cmake_installs(cmake: str, relative: str, expected: str | None, tmp_path: Path) -> None:
    assert source(tmp_path, relative, cmake=cmake) == expected


def setup_py(pairs: str) -> str:
    return f"""import os
from glob import glob
from setuptools import setup
package_name = 'arm'
setup(name=package_name, data_files=[
    ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
    {pairs}
])
"""


@pytest.mark.parametrize(
    ("pairs", "relative", "expected"),
    [
        ("('share/arm/a', ['config/c.yaml'])", "a/c.yaml", "config/c.yaml"),
        ("('share/' + package_name, ['config/c.yaml'])", "c.yaml", "config/c.yaml"),
        ("(os.path.join('share', package_name, 'a'), ['config/c.yaml'])", "a/c.yaml", "config/c.yaml"),
        ("(f'share/{package_name}/a', ['config/c.yaml'])", "a/c.yaml", "config/c.yaml"),
        ("(os.path.join('share', package_name), glob('config/*.yaml'))", "c.yaml", "config/c.yaml"),
        ("('share/arm/u', glob('description/urdf/*'))", "u/r.xacro", "description/urdf/r.xacro"),
        (
            "('share/arm/u', glob(os.path.join('description', 'urdf', '*.xacr?')))",
            "u/r.xacro",
            "description/urdf/r.xacro",
        ),
        ("('share/arm', ['config/c.yaml'] + glob('launch/*'))", "l.py", "launch/l.py"),
        ("('share/arm/a', ['config/c.yaml', name()])", "a/c.yaml", "config/c.yaml"),
        ("(where(), ['config/c.yaml'])", "c.yaml", None),
        ("('lib/arm', ['scripts/run'])", "run", None),
        ("('share/arm', files())", "c.yaml", None),
        ("('share/arm', ['config/none.yaml'])", "none.yaml", None),
    ],
)
def test_setup_py_installs(pairs: str, relative: str, expected: str | None, tmp_path: Path) -> None:
    assert source(tmp_path, relative, setup=setup_py(pairs)) == expected


def test_setup_py_is_never_run(tmp_path: Path) -> None:
    run = f"open({str(tmp_path / 'ran')!r}, 'w')\n"
    assert source(tmp_path, "c.yaml", setup=run + setup_py("('share/arm', ['config/c.yaml'])")) == "config/c.yaml"
    assert not (tmp_path / "ran").exists()


@pytest.mark.parametrize("setup", ["data_files = [", "data_files = '\0'", "(" * 5000 + "data_files"])
def test_a_setup_py_that_is_no_python_installs_nothing(setup: str, tmp_path: Path) -> None:
    assert source(tmp_path, "c.yaml", setup=setup) is None


def test_a_package_without_build_files_installs_nothing(tmp_path: Path) -> None:
    assert read_install_map(str(tmp_path), "arm").rules == []


def test_an_install_rule_that_leads_out_of_the_workspace_lets_nothing_be_read(tmp_path: Path) -> None:
    (tmp_path / "secret.yaml").touch()
    (tmp_path / "w" / "arm").mkdir(parents=True)
    (tmp_path / "w" / "arm" / "CMakeLists.txt").write_text("install(FILES ../../secret.yaml DESTINATION share/arm)")
    resolve = read_install_map(str(tmp_path / "w" / "arm"), "arm").source_of
    assert resolve("secret.yaml") == str(tmp_path / "secret.yaml")
    with pytest.raises(FileProblem, match="outside the workspace"):
        Files([str(tmp_path / "w")], lambda path: resolve(path) or path).read("secret.yaml")


@pytest.mark.parametrize(("words", "whole"), [("launch config", True), ("${all}", False), ("IN LISTS unknown", False)])
def test_a_loop_over_known_words_hides_nothing(words: str, whole: bool, tmp_path: Path) -> None:
    loop = f"foreach(d {words})\ninstall(DIRECTORY ${{d}} DESTINATION share/arm)\nendforeach()\n"
    (tmp_path / "CMakeLists.txt").write_text(loop)
    assert read_install_map(str(tmp_path), "arm").whole is whole


@pytest.mark.parametrize(
    ("command", "whole"),
    [
        ("ament_python_install_package(${PROJECT_NAME})", True),
        ("ament_python_install_package(arm DESTINATION share/arm)", False),
        ("arm_install_files(arm)", False),
        ("install_arm(arm)", False),
    ],
)
def test_python_modules_that_cmake_installs_hide_nothing_in_the_share(
    command: str, whole: bool, tmp_path: Path
) -> None:
    (tmp_path / "CMakeLists.txt").write_text(f"install(DIRECTORY launch DESTINATION share/arm)\n{command}\n")
    assert read_install_map(str(tmp_path), "arm").whole is whole
