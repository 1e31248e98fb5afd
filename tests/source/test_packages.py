"""Packages are found without ROS: where, in which order, and which of several."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from urdfctl.source.workspaces.packages import PackageIndex, PackageNotFound, Packages, package_name


def package(folder: Path, name: str | None = None) -> str:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(f"<package><name>{name or folder.name}</name></package>")
    return str(folder)


def found(
    name: str,
    workspace: Path,
    file: str = "r.xacro",
    *,
    extra: list[Path] | None = None,
    environ: Mapping[str, str] | None = None,
) -> str:
    index = PackageIndex(str(workspace), [str(path) for path in extra or []], environ or {})
    return Packages(str(workspace / file), index).find(name)


@pytest.mark.parametrize(
    ("manifest", "name"),
    [
        ("<package><name>arm</name></package>", "arm"),
        ("<package format='3'>\n  <name>\n arm </name></package>", "arm"),
        ("<package><!-- <name>template</name> --><name>arm</name></package>", "arm"),
        ("<!-- a\n<name>b</name>\n--><package><name>arm</name><author><name>c</name></author></package>", "arm"),
        ("<package><name id='1'>arm</name></package>", "arm"),
        ("<package/>", None),
        ("<package><name></name></package>", None),
        ("", None),
    ],
)
def test_the_name_of_a_package_stands_in_its_manifest(manifest: str, name: str | None, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(manifest)
    assert package_name(str(tmp_path / "package.xml")) == name


def test_a_manifest_that_cannot_be_read_names_nothing(tmp_path: Path) -> None:
    (tmp_path / "package.xml").mkdir()
    assert package_name(str(tmp_path / "package.xml")) is None
    assert package_name(str(tmp_path / "none.xml")) is None


def test_a_files_own_package_is_found(tmp_path: Path) -> None:
    own = package(tmp_path / "src" / "arm", "my_arm")
    assert found("my_arm", tmp_path, "src/arm/urdf/r.xacro") == own
    packages = Packages(str(tmp_path / "src/arm/urdf/r.xacro"), PackageIndex(str(tmp_path), environ={}))
    assert packages.own() == own


def test_a_file_in_no_package_has_none(tmp_path: Path) -> None:
    assert Packages(str(tmp_path / "r.xacro"), PackageIndex(str(tmp_path), environ={})).own() is None


def test_a_sibling_is_found(tmp_path: Path) -> None:
    package(tmp_path / "src" / "arm")
    sibling = package(tmp_path / "src" / "base")
    assert found("base", tmp_path, "src/arm/urdf/r.xacro") == sibling


def test_a_package_anywhere_in_the_workspace_is_found_by_its_name_not_its_folders(tmp_path: Path) -> None:
    package(tmp_path / "src" / "arm")
    far = package(tmp_path / "src" / "x" / "y" / "folder", "base")
    assert found("base", tmp_path, "src/arm/urdf/r.xacro") == far


def test_of_two_packages_of_one_name_the_nearest_is_found(tmp_path: Path) -> None:
    package(tmp_path / "a" / "deep" / "base")
    near = package(tmp_path / "b" / "deep" / "base")
    package(tmp_path / "base_of_all", "base")
    assert found("base", tmp_path, "b/x/y/r.xacro") == near


def test_of_two_packages_equally_near_it_is_always_the_same(tmp_path: Path) -> None:
    first = package(tmp_path / "a" / "one", "base")
    package(tmp_path / "a" / "two", "base")
    assert {found("base", tmp_path, "a/r.xacro") for _ in range(3)} == {first}


@pytest.mark.parametrize("folder", ["build", "install", "log", "devel", ".git", ".hidden", "node_modules"])
def test_what_is_built_or_hidden_is_not_searched(folder: str, tmp_path: Path) -> None:
    package(tmp_path / folder / "x" / "base")
    with pytest.raises(PackageNotFound):
        found("base", tmp_path)


@pytest.mark.parametrize("file", ["COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"])
def test_what_is_to_be_ignored_is_not_searched(file: str, tmp_path: Path) -> None:
    package(tmp_path / "x" / "base")
    (tmp_path / "x" / file).touch()
    with pytest.raises(PackageNotFound):
        found("base", tmp_path)


def test_a_package_in_a_package_is_not_found_but_one_in_the_workspaces_own_is(tmp_path: Path) -> None:
    package(tmp_path, "workspace_itself")
    package(tmp_path / "x" / "outer")
    package(tmp_path / "x" / "outer" / "x" / "inner")
    assert found("outer", tmp_path).endswith("outer")
    with pytest.raises(PackageNotFound):
        found("inner", tmp_path)


def test_symlinked_folders_are_not_searched(tmp_path: Path) -> None:
    package(tmp_path / "outside" / "x" / "base")
    (tmp_path / "w").mkdir()
    (tmp_path / "w" / "link").symlink_to(tmp_path / "outside")
    (tmp_path / "w" / "circle").symlink_to(tmp_path / "w")
    with pytest.raises(PackageNotFound):
        found("base", tmp_path / "w")


def test_a_package_path_goes_before_all(tmp_path: Path) -> None:
    named = package(tmp_path / "named" / "x" / "folder", "base")
    package(tmp_path / "w" / "base")
    sourced = package(tmp_path / "prefix" / "share" / "base")
    environ = {"AMENT_PREFIX_PATH": str(tmp_path / "prefix")}
    assert found("base", tmp_path / "w", extra=[tmp_path / "named"], environ=environ) == named
    assert found("base", tmp_path / "w", extra=[Path(named)]) == named
    assert found("base", tmp_path / "w", environ=environ) == sourced


@pytest.mark.parametrize("variable", ["AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "CMAKE_PREFIX_PATH"])
def test_prefixes_of_a_sourced_environment_are_searched_in_order(variable: str, tmp_path: Path) -> None:
    first = package(tmp_path / "one" / "share" / "base")
    package(tmp_path / "two" / "share" / "base")
    assert found("base", tmp_path / "w", environ={variable: f":{tmp_path}/none:{tmp_path}/one:{tmp_path}/two"}) == first


def test_the_resource_index_names_a_package_that_has_no_manifest(tmp_path: Path) -> None:
    index = tmp_path / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    (index / "base").touch()
    assert found("base", tmp_path / "w", environ={"AMENT_PREFIX_PATH": str(tmp_path)}) == str(tmp_path / "share/base")


def test_ros_package_path_is_searched_as_rospack_does(tmp_path: Path) -> None:
    direct = package(tmp_path / "one" / "base")
    deep = package(tmp_path / "two" / "x" / "folder", "far")
    environ = {"ROS_PACKAGE_PATH": f"{tmp_path}/one:{tmp_path}/two"}
    assert found("base", tmp_path / "w", environ=environ) == direct
    assert found("far", tmp_path / "w", environ=environ) == deep


def test_a_folder_of_that_name_does_where_no_package_is(tmp_path: Path) -> None:
    (tmp_path / "base" / "urdf").mkdir(parents=True)
    packages = Packages(str(tmp_path / "arm" / "r.xacro"), PackageIndex(str(tmp_path), environ={}))
    assert packages.find("base") == str(tmp_path / "base")
    assert packages.assumed == {"base"}


def test_a_link_of_that_name_does_not(tmp_path: Path) -> None:
    (tmp_path / "etc").symlink_to("/etc")
    with pytest.raises(PackageNotFound):
        found("etc", tmp_path)


@pytest.mark.parametrize("name", ["", ".", "..", "../x", "/etc", "a/b"])
def test_a_path_is_no_name_of_a_package(name: str, tmp_path: Path) -> None:
    package(tmp_path / "w" / "a" / "b", "a/b")
    with pytest.raises(PackageNotFound):
        found(name, tmp_path / "w", environ={"AMENT_PREFIX_PATH": str(tmp_path), "ROS_PACKAGE_PATH": str(tmp_path)})


def test_what_is_not_found_tells_which_names_are_known(tmp_path: Path) -> None:
    package(tmp_path / "x" / "base")
    with pytest.raises(PackageNotFound) as raised:
        found("bose", tmp_path)
    assert (raised.value.name, list(raised.value.known)) == ("bose", ["base"])


def test_the_same_last_words_after_the_first_word_of_other_packages_are_no_slip(tmp_path: Path) -> None:
    def meant(name: str) -> tuple[list[str], str]:
        with pytest.raises(PackageNotFound) as raised:
            found(name, tmp_path, "mur_description/r.xacro")
        return sorted(raised.value.known), raised.value.own

    package(tmp_path / "mur_description")
    assert meant("ur_description") == (["mur_description"], "mur_description")
    manifest = Path(package(tmp_path / "base"), "package.xml")
    manifest.write_text("<package><name>base</name><depend>ur_driver</depend></package>")
    assert meant("ur_description") == (["base"], "")
    assert meant("mur_descripton") == (["base", "mur_description"], "mur_description")
    assert meant("mr_description") == (["base", "mur_description"], "mur_description")


def test_an_installed_path_leads_to_its_source(tmp_path: Path) -> None:
    package(tmp_path / "arm")
    (tmp_path / "arm" / "CMakeLists.txt").write_text("install(DIRECTORY description/urdf DESTINATION share/arm)")
    (tmp_path / "arm" / "description" / "urdf").mkdir(parents=True)
    (tmp_path / "arm" / "description" / "urdf" / "i.xacro").touch()
    packages = Packages(str(tmp_path / "r.xacro"), PackageIndex(str(tmp_path), environ={}))
    folder = packages.find("arm")
    assert packages.source_of(f"{folder}/urdf/i.xacro") == f"{folder}/description/urdf/i.xacro"
    assert packages.source_of(f"{folder}/package.xml") == f"{folder}/package.xml"
    assert packages.source_of(f"{folder}/urdf/none.xacro") == f"{folder}/urdf/none.xacro"
    assert packages.source_of("/none") == "/none"


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("/home/me/ws/src/arm/config/c.yaml", "arm/config/c.yaml"),
        ("/home/me/ws/install/arm/share/arm/config/c.yaml", "arm/config/c.yaml"),
        ("/home/me/arm/src/arm/urdf/i.xacro", "arm/description/urdf/i.xacro"),
        ("/home/me/ws/src/arm/config/none.yaml", None),
        ("/home/me/ws/src/leg/config/c.yaml", None),
        ("arm/config/c.yaml", None),
    ],
)
def test_a_path_of_another_machine_leads_to_the_file_of_the_package_in_it(
    tmp_path: Path, path: str, source: str | None
) -> None:
    package(tmp_path / "arm")
    (tmp_path / "arm" / "CMakeLists.txt").write_text("install(DIRECTORY description/urdf DESTINATION share/arm)")
    for name in ("config/c.yaml", "description/urdf/i.xacro"):
        (tmp_path / "arm" / name).parent.mkdir(parents=True)
        (tmp_path / "arm" / name).touch()
    packages = Packages(str(tmp_path / "r.xacro"), PackageIndex(str(tmp_path), environ={}))
    assert packages.source_of(path) == (str(tmp_path / source) if source else path)


def test_a_package_inside_another_one_is_only_used_if_there_is_no_other(tmp_path: Path) -> None:
    package(tmp_path / "outer")
    copy = package(tmp_path / "outer" / "arm")
    assert found("arm", tmp_path, "outer/launch/l.launch") == copy
    real = package(tmp_path / "stack" / "arm")
    assert found("arm", tmp_path, "outer/launch/l.launch") == real
