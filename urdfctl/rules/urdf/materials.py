"""The materials of a robot, in the order in which urdfdom reads them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Link, Robot, Tag
from urdfctl.startup.records import NamedTuple


class Material(NamedTuple):
    """A `<material>` of the robot or of a visual."""

    name: str
    """The name; empty if it has none."""
    tag: Tag
    """The `<material>` element."""
    link: Link | None
    """The link of the visual; None for a material of the robot."""

    @property
    def colour(self) -> Tag | None:
        """Return the `<color>`, if it has an rgba."""
        color = next(self.tag.named("color"), None)
        return color if color is not None and "rgba" in color.attributes else None

    @property
    def texture(self) -> Tag | None:
        """Return the `<texture>`, if it has a filename."""
        texture = next(self.tag.named("texture"), None)
        return texture if texture is not None and "filename" in texture.attributes else None

    @property
    def is_definition(self) -> bool:
        """Return whether it defines an appearance, rather than refer to another material by name."""
        return self.link is None or self.looks != (None, None)

    @property
    def looks(self) -> tuple[str | None, str | None]:
        """Return the colour and the texture file as written."""
        colour, texture = self.colour, self.texture
        rgba = " ".join(colour.attributes["rgba"].split()) if colour else None
        return rgba, texture.attributes["filename"] if texture else None

    @property
    def label(self) -> str:
        """Return the material as messages name it."""
        return f"material '{self.name}'" + (f" of link '{self.link.name}'" if self.link else "")


def materials_of(robot: Robot) -> Iterator[Material]:
    """Yield the materials of the robot, then those of the visuals, link by link."""
    for tag in robot.others:
        if tag.name == "material":
            yield Material(tag.attributes.get("name", ""), tag, None)
    for link in robot.links:
        for visual in link.tag.named("visual"):
            material = next(visual.named("material"), None)
            if material is not None:
                yield Material(material.attributes.get("name", ""), material, link)
