"""Where the simulator looks for models and plugins: environment variables, and the export of package.xml."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.python_paths import with_default, without_classic_paths
from urdfctl.migrate.classic.sdf import MODELS, model_folders
from urdfctl.migrate.edits.markup import appended, attribute, child, content, end_of, root_of, step_of
from urdfctl.migrate.edits.python_edits import PythonFile
from urdfctl.migrate.edits.tokens import HOOKS, tokens_in
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz, leaves_classic
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.disk.files import is_launch
from urdfctl.source.disk.gate import is_folder, walk
from urdfctl.source.span import Place, SourceSpan
from urdfctl.source.xml.dom import Element

_VARIABLES = "gz-sim tutorials/resources.md: GZ_SIM_RESOURCE_PATH, GZ_SIM_SYSTEM_PLUGIN_PATH"
_LAUNCH = "gazebo_ros scripts/gazebo_ros_paths.py; ros_gz#492: gz_sim.launch.py finds the same paths"
_EXPORT = "ros_gz_sim README, gazebo_ros gazebo_ros_paths.py: <gazebo_ros gazebo_model_path> in package.xml"
VARIABLES: Mapping[str, str] = {
    "GAZEBO_MODEL_PATH": "GZ_SIM_RESOURCE_PATH",
    "GAZEBO_RESOURCE_PATH": "GZ_SIM_RESOURCE_PATH",
    "GAZEBO_PLUGIN_PATH": "GZ_SIM_SYSTEM_PLUGIN_PATH",
}
_NAME = re.compile(rb"(?<!\w)GAZEBO_(?:MODEL|RESOURCE|PLUGIN)_PATH(?!\w)")
_OF_PYTHON = re.compile(rb"GazeboRosPaths|environ|EnvironmentVariable")
_OF_XML = (".xacro", ".urdf", ".gazebo")
_INSIDE = re.compile(rb"['\"]?\)?[\s,]*['\"]?/(?!\.\.)[\w.-]")
_NEAR = 300
"""Bytes around the name of a variable in which its value is mostly written."""


def _variables(packages: MigratedPackages) -> Iterator[Proposal]:
    if not leaves_classic(packages) or not goes_to_gz(packages):
        return
    for path in packages.files(*HOOKS, ".py", ".xml", ".launch", ".yaml", ".yml"):
        source = packages.read(path)
        is_read = is_launch(path) or path.endswith((*HOOKS, ".py"))
        if not is_read or not packages.may_change(path):
            continue
        file = PythonFile(source) if path.endswith(".py") and _OF_PYTHON.search(source.data) else None
        if file is not None and (gone := tuple(without_classic_paths(file))):
            what = "gazebo_ros no longer says where packages have models: gz's launch file looks there itself"
            at = Place(source, gone[0].span.start, end=gone[0].span.end)
            yield Proposal(gone, entries=(ReportEntry(EntryKind.DONE, what, at, authority=_LAUNCH),))
        if not _NAME.search(source.data):
            continue
        names = [found.span() for token in tokens_in(source) for found in _NAME.finditer(source.data, *token[1:])]
        edits = [Edit(SourceSpan(source, *span), VARIABLES[source.data[slice(*span)].decode()]) for span in names]
        if edits:
            first = edits[0]
            at = Place(source, first.span.start, end=first.span.end)
            what = f"'{first.span.text}' was renamed to '{first.text}'"
            edits += with_default(file, VARIABLES) if file is not None else ()
            yield Proposal(tuple(edits), entries=(ReportEntry(EntryKind.DONE, what, at, authority=_VARIABLES),))


def _exports(packages: MigratedPackages) -> Iterator[Proposal]:
    stays_classic = packages.is_ros1 and packages.simulator == "gazebo-classic"
    if not (goes_to_gz(packages) and not packages.was_in_gz) and not stays_classic:
        return
    used = set(_packages_of_meshes(packages))
    for path in packages.files("package.xml"):
        root = root_of(packages.read(path)) if os.path.basename(path) == "package.xml" else None
        name = child(root, "name") if root is not None else None
        if root is None or name is None:
            continue
        export, folder = child(root, "export"), os.path.dirname(path)
        is_used = content(name) in used or is_folder(os.path.join(folder, "meshes"))
        known = {one.rstrip("/") for one in _exported(export)}
        paths = [one for one in _paths(packages, folder, content(name), is_used=is_used) if one not in known]
        lines = [f'<gazebo_ros gazebo_model_path="{one}"/>' for one in paths]
        if lines and (edit := _added(root, export, lines)) is not None:
            what = "the package exports where the simulator finds its meshes and models"
            at = export.at if export is not None else root.at
            yield Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, what, at, authority=_EXPORT),))


def _exported(export: Element | None) -> Iterator[str]:
    """The folders that a package exports already; several are separated as in a variable of the environment."""
    for one in export.elements() if export is not None else ():
        yield from attribute(one, "gazebo_model_path").split(":")


def _packages_of_meshes(packages: MigratedPackages) -> Iterator[str]:
    """The packages whose files robots show: gz finds them by the name of the package."""
    for path in packages.files(*_OF_XML):
        for found in re.finditer(rb"(?:package|model)://([\w-]+)/", packages.read(path).data):
            yield found[1].decode()


def _paths(packages: MigratedPackages, folder: str, name: str, *, is_used: bool) -> Iterator[str]:
    """The parent folder of a package, and its folders of models, unless they are set already."""
    if is_used and not _is_set(packages, name, _INSIDE):
        yield "${prefix}/.."
    has_models = any(file == "model.config" for _, _, files in walk(os.path.join(folder, MODELS)) for file in files)
    for relative in (*([MODELS] if has_models else []), *packages.found(model_folders).get(folder, ())):
        if not _is_set(packages, name, _other_than(relative)):
            yield "${prefix}" if relative == os.curdir else f"${{prefix}}/{relative}"


def _other_than(relative: str) -> re.Pattern[bytes]:
    """What follows the name of a package where it is for another folder than one of its own."""
    first = re.escape(relative.partition("/")[0].encode())
    return re.compile(rb"['\"]?\)?[\s,]*['\"]?/(?!\.\.|%s)[\w.-]" % first)


def _is_set(packages: MigratedPackages, name: str, other: re.Pattern[bytes]) -> bool:
    """Whether a launch file or a hook of the packages says where the models of a package are.

    other: what follows the name where it is for another folder.
    """
    near = re.compile(rb"(?s)(?<![\w-])%s(?![\w-])" % re.escape(name.encode()))
    for path in packages.files(*HOOKS, ".py", ".xml"):
        text = packages.read(path).data
        for found in re.finditer(rb"(?:GZ_SIM|IGN_GAZEBO)_RESOURCE_PATH", text):
            around = near.finditer(text, max(found.start() - _NEAR, 0), found.end() + _NEAR)
            if any(not other.match(text, one.end()) for one in around):
                return True
    return False


def _added(root: Element, export: Element | None, lines: list[str]) -> Edit | None:
    """The edit that adds lines at the end of <export>, or this with them, before an end tag on a line of its own."""
    source, step = root.source, step_of(root.source)
    around, inner = (export, [f"{step}{line}" for line in lines]) if export is not None else (root, [])
    inner = inner or ["<export>", *(f"{step}{line}" for line in lines), "</export>"]
    if around.close is None:
        return None
    start = source.data.rfind(b"\n", 0, around.close) + 1
    if source.data[start : around.close].strip() or end_of(around) < around.close:
        return None
    return appended(around, (f"{step}{line}" for line in inner))


ENVIRONMENT = Step(
    name="environment",
    part=Part.LAUNCH,
    summary="Environment variables of Gazebo Classic",
    propose=_variables,
    rows=tuple(Row(old, new, "jazzy", _VARIABLES) for old, new in VARIABLES.items()),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import SetEnvironmentVariable


                def generate_launch_description():
                    return LaunchDescription([SetEnvironmentVariable("GAZEBO_MODEL_PATH", "/models")])
            """,
        },
    ],
    after=[
        {
            "launch/arm.launch.py": """
                from launch import LaunchDescription
                from launch.actions import SetEnvironmentVariable


                def generate_launch_description():
                    return LaunchDescription([SetEnvironmentVariable("GZ_SIM_RESOURCE_PATH", "/models")])
            """,
        },
    ],
)
MODEL_PATHS = Step(
    name="model-paths",
    part=Part.MANIFEST,
    summary="Meshes and models of a package",
    propose=_exports,
    rows=(Row("meshes of a package", '<gazebo_ros gazebo_model_path="${prefix}/.."/> in package.xml', "", _EXPORT),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <export>
                    <build_type>ament_cmake</build_type>
                  </export>
                </package>
            """,
            "meshes/arm.obj": "v 0 0 0",
        },
    ],
    after=[
        {
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <export>
                    <build_type>ament_cmake</build_type>
                    <gazebo_ros gazebo_model_path="${prefix}/.."/>
                  </export>
                </package>
            """,
        },
    ],
)
