"""What the rules on addresses of meshes share: how they would be right."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.model.robot import Mesh
from urdfctl.rule import Edit, Fix


def in_packages(meshes: Sequence[Mesh]) -> Fix | None:
    """The repair that gives each of some meshes its package:// address; for a person to make where one has none that is
    known, or the source does not name it literally. None where the first has none."""
    right = [mesh.file.address if mesh.file else None for mesh in meshes]
    if not right[0]:
        return None
    edits = [Edit(mesh.at.span, address) for mesh, address in zip(meshes, right, strict=True) if address]
    is_sure = len(edits) == len(meshes) and all(mesh.at.span.text == mesh.filename for mesh in meshes)
    more = ", and so on" if len(meshes) > 1 else ""
    return Fix(f"write {right[0]}{more}", tuple(dict.fromkeys(edits)) if is_sure else ())
