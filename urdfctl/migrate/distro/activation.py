"""Hardware components that the controller manager was told to activate, where the others stayed as they were."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.moves import MANAGER
from urdfctl.migrate.edits.yaml_edits import ByName, MapEdits, deepest, leaves, texts_at
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, sections
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import todo_line

_ACTIVATED = "activate_components_on_start"
_UNCONFIGURED = "hardware_components_initial_state.unconfigured"
_NOT_ACTIVATED = ("configure_components_on_start", "hardware_components_initial_state.inactive", _UNCONFIGURED)
_AUTHORITY = (
    "ros2_control humble controller_manager.cpp, init_resource_manager: with activate_components_on_start no other "
    "component is activated; jazzy activates all that hardware_components_initial_state does not name"
)
_UNKNOWN = f"all hardware components are activated now: name those that should not be in {_UNCONFIGURED}"


def _activation(packages: MigratedPackages) -> Iterator[Proposal]:
    for section in packages.found(sections) if packages.reaches("jazzy") else ():
        if section.type == MANAGER and packages.may_change(section.path):
            given = dict(leaves(section.parameters))
            activated = texts_at(given, _ACTIVATED)
            if activated:
                yield _kept(packages, section, given, activated)


def _kept(packages: MigratedPackages, section: FileSection, given: ByName, activated: list[str]) -> Proposal:
    """The proposal to leave the other components of a manager's robots unconfigured, as they were."""
    known = _components(packages, activated)
    named = {*activated, *(name for key in _NOT_ACTIVATED for name in texts_at(given, key))}
    others = [name for name in known if name not in named]
    path = given[_ACTIVATED]
    parent, entry = path[-1]
    edits = MapEdits(packages.read(section.path))
    entries = [ReportEntry(EntryKind.DONE, f"'{_ACTIVATED}' is dropped", entry.key.at, authority=_AUTHORITY)]
    if not known:
        edits.insert(parent, todo_line(section.path, _UNKNOWN), after=entry)
        entries.append(ReportEntry(EntryKind.FOR_YOU, _UNKNOWN, entry.key.at, authority=_AUTHORITY))
    elif others:
        what = f"{_those(others)} not activated at the start, as before: {_UNCONFIGURED}"
        entries.append(ReportEntry(EntryKind.DONE, what, entry.key.at, authority=_AUTHORITY))
        text = ", ".join([*texts_at(given, _UNCONFIGURED), *others])
        if _UNCONFIGURED in given:
            edits.replace(given[_UNCONFIGURED][-1][1].value, f"[{text}]")
        else:
            owner, key = deepest(section.parameters, _UNCONFIGURED)
            edits.insert(owner, f"{key}: [{text}]", after=entry if owner is parent else None)
    edits.drop(path)
    return Proposal(edits=edits.edits(), entries=tuple(entries), fixes=("UC435", "UC436"))


def _components(packages: MigratedPackages, activated: list[str]) -> list[str]:
    """The hardware components of all robots that have one of the activated ones, in order."""
    found: dict[str, None] = {}
    for loaded in packages.loaded():
        robot = loaded.project.robot
        names = [control.name for control in robot.ros2_controls if control.name] if robot else []
        if any(name in activated for name in names):
            found.update(dict.fromkeys(names))
    return list(found)


def _those(names: list[str]) -> str:
    """Components in words, with their verb."""
    return ", ".join(f"'{name}'" for name in names) + (" is" if len(names) == 1 else " are")


_ROBOT = """
    <robot name="r">
      <link name="base"/>
      <link name="arm"/>
      <link name="finger"/>
      <joint name="arm" type="continuous">
        <parent link="base"/>
        <child link="arm"/>
        <axis xyz="0 0 1"/>
      </joint>
      <joint name="finger" type="continuous">
        <parent link="arm"/>
        <child link="finger"/>
        <axis xyz="0 0 1"/>
      </joint>
      <ros2_control name="arm" type="system">
        <hardware>
          <plugin>mock_components/GenericSystem</plugin>
        </hardware>
        <joint name="arm">
          <command_interface name="position"/>
          <state_interface name="position"/>
        </joint>
      </ros2_control>
      <ros2_control name="gripper" type="system">
        <hardware>
          <plugin>mock_components/GenericSystem</plugin>
        </hardware>
        <joint name="finger">
          <command_interface name="position"/>
          <state_interface name="position"/>
        </joint>
      </ros2_control>
    </robot>
"""

ACTIVATION = Step(
    name="component-activation",
    part=Part.YAML,
    summary="Hardware components that are not activated at the start",
    propose=_activation,
    is_needed=True,
    rows=(Row(_ACTIVATED, f"{_UNCONFIGURED}, with the other components", "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--from=humble --to=jazzy",
            "urdf/r.urdf": _ROBOT,
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    activate_components_on_start: [arm]
            """,
        },
        {
            "options": "--from=humble --to=jazzy",
            "urdf/r.urdf": _ROBOT,
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    activate_components_on_start: [arm, gripper]
            """,
        },
        {
            "options": "--from=humble --to=jazzy",
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    activate_components_on_start: [arm]
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    hardware_components_initial_state.unconfigured: [gripper]
            """,
        },
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
            """,
        },
        {
            "config/controllers.yaml": f"""
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    # TODO(urdfctl): {_UNKNOWN}
            """,
        },
    ],
)
