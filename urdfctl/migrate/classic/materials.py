"""Materials by the name of a script of Gazebo Classic become colours, because gz does not read scripts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.choice import is_chosen, replaced
from urdfctl.migrate.classic.sdf import sdf_elements
from urdfctl.migrate.edits.markup import (
    child,
    content,
    elements,
    indent_of,
    indented,
    parent_of,
    removal,
    root_of,
    span_of,
    step_of,
)
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you

_AUTHORITY = (
    "gz-sim tutorials/migration_sdf: material scripts are not supported; gazebo media/materials/scripts/gazebo.material"
)
COLOURS: Mapping[str, str] = {
    "Black": "0 0 0 1",
    "FlatBlack": "0.1 0.1 0.1 1",
    "White": "1 1 1 1",
    "Grey": "0.7 0.7 0.7 1",
    "Gray": "0.7 0.7 0.7 1",
    "LightGrey": "0.9 0.9 0.9 1",
    "DarkGrey": "0.175 0.175 0.175 1",
    "DarkGray": "0.175 0.175 0.175 1",
    "Red": "1 0 0 1",
    "Green": "0 1 0 1",
    "Blue": "0 0 1 1",
    "Yellow": "1 1 0 1",
    "DarkYellow": "0.7 0.7 0 1",
    "Orange": "1 0.5088 0.0468 1",
    "Purple": "1 0 1 1",
    "Indigo": "0.33 0 0.5 1",
    "Turquoise": "0 1 1 1",
    "SkyBlue": "0.13 0.44 0.7 1",
    "Gold": "0.8 0.649 0.123 1",
    "Chrome": "0.8 0.8 0.8 1",
    "Wood": "0.6 0.45 0.3 1",
}
"""The diffuse colours of Gazebo Classic's materials, as red, green, blue and alpha from 0 to 1."""


def _materials(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    yield from _scripts(packages)
    for path in packages.files(*OF_XML):
        source = packages.read(path)
        root = root_of(source) if b"Gazebo/" in source.data else None
        for element in elements(root) if root is not None else ():
            around = parent_of(element)
            name = content(element)
            if element.tagName != "material" or around is None or around.tagName != "gazebo" or is_chosen(element):
                continue
            colour = COLOURS.get(name.removeprefix("Gazebo/")) if name.startswith("Gazebo/") else None
            if colour is None:
                continue
            step = step_of(source)
            lines = (f"{step * 2}<{kind}>{colour}</{kind}>\n" for kind in ("ambient", "diffuse"))
            text = f"<visual>\n{step}<material>\n{''.join(lines)}{step}</material>\n</visual>\n"
            entry = ReportEntry(EntryKind.DONE, f"material '{name}' became a colour", element.at, authority=_AUTHORITY)
            yield Proposal(tuple(replaced(packages, element, text)), entries=(entry,))


def _scripts(packages: MigratedPackages) -> Iterator[Proposal]:
    """Write the colours of the scripts in worlds and models."""
    unknown: set[tuple[str, str]] = set()
    for element in sdf_elements(packages, b"<script"):
        around, named = parent_of(element), child(element, "name")
        if element.tagName != "script" or around is None or around.tagName != "material" or named is None:
            continue
        name, path = content(named), element.source.path
        colour = COLOURS.get(name.removeprefix("Gazebo/")) if name.startswith("Gazebo/") else None
        missing = [kind for kind in ("ambient", "diffuse") if child(around, kind) is None]
        if colour is not None or not missing:
            lines = "\n".join(f"<{kind}>{colour}</{kind}>" for kind in missing)
            edit = Edit(span_of(element), indented(lines, indent_of(element)).lstrip()) if lines else removal(element)
            what = f"material '{name}' became a colour"
            yield Proposal((edit,), entries=(ReportEntry(EntryKind.DONE, what, element.at, authority=_AUTHORITY),))
        elif (path, name) not in unknown:
            unknown.add((path, name))
            what = f"gz does not read the script of material '{name}': write <diffuse>, or <pbr> with its texture"
            yield for_you(element.at, what, authority=_AUTHORITY)


CLASSIC_MATERIALS = Step(
    name="classic-materials",
    part=Part.URDF,
    summary="Materials of Gazebo Classic",
    propose=_materials,
    rows=(
        Row("<material>Gazebo/NAME</material>", "<visual><material><ambient>, <diffuse>", "jazzy", _AUTHORITY),
        Row("<material><script> Gazebo/NAME in SDF", "<ambient>, <diffuse>", "jazzy", _AUTHORITY),
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo reference="fore">
                  <material>Gazebo/Orange</material>
                </gazebo>
            """,
        },
        {
            "options": "--to=jazzy --simulator=gz",
            "world.sdf": """
                <sdf version="1.6">
                  <world name="hall">
                    <model name="box">
                      <link name="box">
                        <visual name="box">
                          <material>
                            <script>
                              <uri>file://media/materials/scripts/gazebo.material</uri>
                              <name>Gazebo/Blue</name>
                            </script>
                          </material>
                        </visual>
                      </link>
                    </model>
                  </world>
                </sdf>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <visual>
                    <material>
                      <ambient>1 0.5088 0.0468 1</ambient>
                      <diffuse>1 0.5088 0.0468 1</diffuse>
                    </material>
                  </visual>
                </gazebo>
            """,
        },
        {
            "world.sdf": """
                <sdf version="1.6">
                  <world name="hall">
                    <model name="box">
                      <link name="box">
                        <visual name="box">
                          <material>
                            <ambient>0 0 1 1</ambient>
                            <diffuse>0 0 1 1</diffuse>
                          </material>
                        </visual>
                      </link>
                    </model>
                  </world>
                </sdf>
            """,
        },
    ],
)
