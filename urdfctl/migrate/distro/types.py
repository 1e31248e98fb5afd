"""Types of controllers that a later distro does not have, with the parameters that their successors need."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.catalog import CATALOG
from urdfctl.catalog.distros import ROS2, generation
from urdfctl.catalog.entries import Replacement
from urdfctl.catalog.map_parameters import matching
from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.xml_edits import elements_of, span_of, words_of
from urdfctl.migrate.edits.yaml_edits import MapEdits, leaves
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import FileSection, TypeName, sections, type_names
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "ros2_controllers doc/migration.rst: removed types and their successors"


def _types(packages: MigratedPackages) -> Iterator[Proposal]:
    target = packages.options.target
    known = packages.found(sections)
    for declared in packages.found(type_names):
        old = declared.value.text
        instead = CATALOG.replacement(old, target)
        is_ros2 = any(generation(distro) == 2 for distro in CATALOG.distros_of(old))  # noqa: PLR2004
        if instead and is_ros2 and CATALOG.controller(old, target) is None and packages.may_change(declared.path):
            own = [s for s in known if s.node == declared.controller and s.type == old]
            yield _proposal(declared, instead, own, target)


def _proposal(declared: TypeName, instead: Replacement, own: list[FileSection], target: str) -> Proposal:
    """The proposal to change the type of a controller, and to add the parameters that the new type needs.

    Parameters that only the new type reads had no effect; so they are dropped.
    """
    scalar = declared.value
    by_path = {section.path: MapEdits(section.parameters.source) for section in own}
    edits = by_path.setdefault(declared.path, MapEdits(scalar.source))
    edits.replace(scalar, instead.type)
    for section in own:
        for name, value in instead.parameters.items():
            if section.parameters.entries and section.parameters.get(name) is None:
                by_path[section.path].insert(
                    section.parameters, f"{name}: {_yaml(value)}", after=section.parameters.entries[-1]
                )
    what = f"controller type '{scalar.text}' became '{instead.type}'"
    entries = [ReportEntry(EntryKind.DONE, what, scalar.at, authority=_AUTHORITY)]
    for section in own:
        for name, path in list(leaves(section.parameters)):
            if _is_read_only_by(name, scalar.text, instead.type, target):
                by_path[section.path].drop(path)
                dropped = f"'{name}' is dropped: the old type did not read it, and the new one would"
                at = path[-1][1].key.at
                entries.append(
                    ReportEntry(EntryKind.DECIDED, dropped, at, authority=_AUTHORITY, option=f"add {name} again")
                )
    if instead.note:
        entries.append(ReportEntry(EntryKind.DECIDED, instead.note, scalar.at, authority=_AUTHORITY))
    all_edits: list[Edit] = [edit for one in by_path.values() for edit in one.edits()]
    return Proposal(tuple(all_edits), entries=tuple(entries), fixes=("UC422",))


def _is_read_only_by(name: str, old: str, new: str, target: str) -> bool:
    """Whether a type reads a parameter that the type which it replaces never read."""
    kinds = [kind for distro in ROS2 if (kind := CATALOG.controller(old, distro))]
    now = CATALOG.controller(new, target)
    was_read = any(matching(name, kind.parameters) or matching(name, kind.former) for kind in kinds)
    return now is not None and not was_read and matching(name, now.parameters) is not None


def _yaml(value: object) -> str:
    return f"[{', '.join(map(str, value))}]" if isinstance(value, (list, tuple)) else str(value)


# -- the packages that provide them ------------------------------------------------------------------------------------


def _dependencies(packages: MigratedPackages) -> Iterator[Proposal]:
    """Depend on the packages of the new types; no longer on those of the old ones if nothing uses them."""
    target = packages.options.target
    used = {declared.value.text for declared in packages.found(type_names)}
    needed = {kind.package for name in used if (kind := CATALOG.controller(name, target))}
    successors = _successors(target)
    for path in packages.files("package.xml"):
        elements = list(elements_of(packages.read(path)))
        known = {words_of(one) for one in elements if one.tagName.endswith("depend")}
        for element in elements:
            old = words_of(element)
            new = successors.get(old, "") if element.tagName.endswith("depend") else ""
            if new in needed and new not in known:
                yield _renamed_dependency(element, old, new, is_gone=old not in needed)


def _successors(target: str) -> dict[str, str]:
    """The packages of types that the target does not have, each with the package of their successors."""
    found: dict[str, str] = {}
    for name in sorted({name for distro in ROS2 for name in CATALOG.known_types(distro)}):
        instead = CATALOG.replacement(name, target)
        old = next((kind for distro in reversed(ROS2) if (kind := CATALOG.controller(name, distro))), None)
        new = CATALOG.controller(instead.type, target) if instead else None
        if old and new and CATALOG.controller(name, target) is None and old.package != new.package:
            found[old.package] = new.package
    return found


def _renamed_dependency(element: Element, old: str, new: str, *, is_gone: bool) -> Proposal:
    span = span_of(element)
    text = span.text.replace(old, new)
    line = span.source.data.rfind(b"\n", 0, span.start) + 1
    indent = span.source.data[line : span.start].decode("utf-8", "replace")
    edit = Edit(span, text) if is_gone else Edit(SourceSpan(span.source, span.end, span.end), f"\n{indent}{text}")
    what = f"'{new}' provides the controllers that '{old}' provided"
    return Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, what, element.at, authority=_AUTHORITY),))


def _rows() -> Iterator[Row]:
    for name in sorted({name for distro in ROS2 for name in CATALOG.known_types(distro)}):
        there = [distro for distro in CATALOG.distros_of(name) if distro in ROS2]
        gone = ROS2[ROS2.index(there[-1]) + 1 :]
        instead = CATALOG.replacement(name, gone[0]) if gone else None
        if instead:
            yield Row(name, instead.type, gone[0], _AUTHORITY)


DEPENDENCIES = Step(
    "controller-packages",
    Part.MANIFEST,
    "Packages of controllers",
    _dependencies,
    before=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <exec_depend>joint_state_controller</exec_depend>
                </package>
            """,
        },
    ],
    after=[
        {
            "package.xml": """
                <package format="3">
                  <name>arm</name>
                  <exec_depend>joint_state_broadcaster</exec_depend>
                </package>
            """,
        },
    ],
)
TYPES = Step(
    "controller-types",
    Part.YAML,
    "Types of controllers",
    _types,
    tuple(_rows()),
    before=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_controller/JointStateController
            """,
        },
    ],
    after=[
        {
            "config/controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states:
                      type: joint_state_broadcaster/JointStateBroadcaster
            """,
        },
    ],
)
