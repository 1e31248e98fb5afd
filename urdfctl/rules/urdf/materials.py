"""The materials of a robot, in the order in which urdfdom comes to know them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.parts import Tag
from urdfctl.model.robot import Link, Robot
from urdfctl.record import NamedTuple


class Material(NamedTuple):
    """A `<material>`: of the robot where `link` is None, else of a visual."""

    name: str
    tag: Tag
    link: Link | None

    @property
    def colour(self) -> Tag | None:
        """Its `<color>` that gives one."""
        color = next(self.tag.named("color"), None)
        return color if color is not None and "rgba" in color.attributes else None

    @property
    def texture(self) -> Tag | None:
        """Its `<texture>` that names a file."""
        texture = next(self.tag.named("texture"), None)
        return texture if texture is not None and "filename" in texture.attributes else None

    @property
    def is_definition(self) -> bool:
        """Whether it says what it looks like, and does not just refer to another by its name."""
        return self.link is None or self.looks != (None, None)

    @property
    def looks(self) -> tuple[str | None, str | None]:
        """What it looks like, as it is written: colour and texture."""
        colour, texture = self.colour, self.texture
        rgba = " ".join(colour.attributes["rgba"].split()) if colour else None
        return rgba, texture.attributes["filename"] if texture else None

    @property
    def label(self) -> str:
        """What a message calls it."""
        return f"material '{self.name}'" + (f" of link '{self.link.name}'" if self.link else "")


def materials_of(robot: Robot) -> Iterator[Material]:
    """The robot's own first, then those of the visuals, link by link."""
    for tag in robot.others:
        if tag.name == "material":
            yield Material(tag.attributes.get("name", ""), tag, None)
    for link in robot.links:
        for visual in link.tag.named("visual"):
            material = next(visual.named("material"), None)
            if material is not None:
                yield Material(material.attributes.get("name", ""), material, link)
