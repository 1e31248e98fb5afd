"""UC147."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, robot_in
from urdfctl.rules.urdf.materials import materials_of
from urdfctl.rules.urdf.numbers import Field, fault_of, refusing
from urdfctl.source.span import Place

RGBA = 4
BYTE = 255


@rule(
    "UC147",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom_headers urdf_model/color.h Color::init(); urdfdom: 'Material [...] has malformed color rgba values'",
    bad=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="«128 128 128 255»"/></material>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
            """,
        },
    ],
)
def colour_malformed(project: Project) -> Iterator[Finding]:
    """Colour is not four numbers from 0 to 1.

    urdfdom prints an error and drops the colour. It silently replaces a colour of three numbers with its own. Before
    noetic it accepted numbers above 1, and the link is then white.
    """
    robot = robot_in(project)
    for material in materials_of(robot) if robot else ():
        colour = material.colour
        text = colour.attributes["rgba"] if colour else ""
        if colour is None or not is_known(text):
            continue
        field, at = Field(colour, "rgba", text, RGBA), colour.at["rgba"]
        if set(refusing(field)) & set(project.distros):
            yield Finding(at, f"'rgba' of {material.label} is '{field.shown}': {fault_of(field)}")
        elif any(not 0 <= value <= 1 for value in field.values):
            message = f"'rgba' of {material.label} is '{text}'; each number must be from 0 to 1"
            yield Finding(at, message, fix=_fix(at, text, field.values))


def _fix(at: Place, text: str, values: list[float]) -> Fix | None:
    """Scale a colour from bytes (0 to 255) to 0 to 1; its opacity may already be from 0 to 1.

    With no number above 2, as in `1 1 1 2`, it is no colour of bytes.
    """
    *colour, opacity = values
    are_bytes = all(value in range(BYTE + 1) for value in colour) and 0 <= opacity <= BYTE
    if not are_bytes or max(values) <= 2:  # noqa: PLR2004
        return None
    right = [value / BYTE for value in colour] + [opacity / BYTE if opacity > 1 else opacity]
    return replaced(at, text, " ".join(f"{value:.3g}" for value in right))
