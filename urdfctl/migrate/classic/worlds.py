"""Worlds of Gazebo Classic: models from its online database, plugins of the world and of the window."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.sdf import own_models, sdf_elements
from urdfctl.migrate.classic.systems import library_of
from urdfctl.migrate.edits.markup import attribute, content, indent_of, parent_of, removal, span_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you, todo_line
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gazebosim.org, Migrating Gazebo Classic ROS 2 packages: worlds"
_PLUGINS = "gz-sim server.config: a world that names a plugin gets none of the default systems"
_MODEL = "model://"
_FUEL = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/"
ON_FUEL: Mapping[str, str] = {"sun": "Sun", "ground_plane": "Ground Plane"}
"""The models of Gazebo Classic that its guide names on Fuel."""
_BUILT_IN = ("gazebo_ros_init", "gazebo_ros_factory", "gazebo_ros_api_plugin", "gazebo_ros_paths_plugin")
"""Plugins of worlds whose work gz and ros_gz do without being asked."""


def _models(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    own = own_models(packages)
    unknown: set[tuple[str, str]] = set()
    for element in sdf_elements(packages, _MODEL.encode()):
        text = content(element)
        if element.tagName != "uri" or not text.startswith(_MODEL):
            continue
        name = text.removeprefix(_MODEL).partition("/")[0]
        if name in own or "$" in name:
            continue
        if name in ON_FUEL and text.rstrip("/") == f"{_MODEL}{name}":
            address = _FUEL + ON_FUEL[name]
            edit = Edit(span_of(element), f"<uri>{address}</uri>")
            entry = ReportEntry(EntryKind.DONE, f"'{text}' became '{address}'", element.at, authority=_AUTHORITY)
            yield Proposal((edit,), entries=(entry,))
        elif (element.source.path, name) not in unknown:
            unknown.add((element.source.path, name))
            what = f"model '{name}' is not in these packages: add it to one, or name its address on Fuel"
            yield for_you(element.at, what, authority=_AUTHORITY)


def _plugins(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    for element in sdf_elements(packages, b"<plugin"):
        around = parent_of(element)
        library = library_of(attribute(element, "filename"))
        is_classic = element.tagName == "plugin" and attribute(element, "filename").endswith(".so")
        if not is_classic or around is None or around.tagName not in {"world", "gui"} or _is_of_gz(library):
            continue
        if library in _BUILT_IN:
            what = f"plugin '{library}' of the world is removed: gz and ros_gz do its work"
            entry = ReportEntry(EntryKind.DONE, what, element.at, authority=_AUTHORITY)
            yield Proposal((removal(element),), entries=(entry,))
        else:
            yield _commented(element, library)


def _is_of_gz(library: str) -> bool:
    return library.startswith(("gz-", "ignition-"))


def _commented(element: Element, library: str) -> Proposal:
    """The proposal to keep a plugin as a comment, because gz loads no default system beside it."""
    what = f"plugin '{library}' is kept as a comment: no system of gz replaces it"
    old = span_of(element).text.replace("<!--", "").replace("-->", "").replace("--", "- -")
    edit = Edit(span_of(element), f"{todo_line(element.source.path, what)}\n{indent_of(element)}<!-- {old} -->")
    return Proposal((edit,), entries=(ReportEntry(EntryKind.FOR_YOU, what, element.at, authority=_PLUGINS),))


WORLD_MODELS = Step(
    name="world-models",
    part=Part.URDF,
    summary="Models in worlds of Gazebo Classic",
    propose=_models,
    rows=tuple(Row(f"{_MODEL}{old}", _FUEL + new, "jazzy", _AUTHORITY) for old, new in ON_FUEL.items()),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "worlds/hall.world": """
                <sdf version="1.6">
                  <world name="hall">
                    <include>
                      <uri>model://sun</uri>
                    </include>
                  </world>
                </sdf>
            """,
        },
    ],
    after=[
        {
            "worlds/hall.world": """
                <sdf version="1.6">
                  <world name="hall">
                    <include>
                      <uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/Sun</uri>
                    </include>
                  </world>
                </sdf>
            """,
        },
    ],
)
WORLD_PLUGINS = Step(
    name="world-plugins",
    part=Part.URDF,
    summary="Plugins of worlds of Gazebo Classic",
    propose=_plugins,
    rows=tuple(Row(f"lib{name}.so", "", "jazzy", _AUTHORITY) for name in _BUILT_IN),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "worlds/hall.world": """
                <sdf version="1.6">
                  <world name="hall">
                    <plugin name="init" filename="libgazebo_ros_init.so"/>
                    <plugin name="people" filename="libpeople.so"/>
                  </world>
                </sdf>
            """,
        },
    ],
    after=[
        {
            "worlds/hall.world": """
                <sdf version="1.6">
                  <world name="hall">
                    <!-- TODO(urdfctl): plugin 'people' is kept as a comment: no system of gz replaces it -->
                    <!-- <plugin name="people" filename="libpeople.so"/> -->
                  </world>
                </sdf>
            """,
        },
    ],
)
