"""The fix shared by the rules on mesh addresses."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.model.robot import Mesh, MeshFile
from urdfctl.rule import Edit, Fix


def in_packages(meshes: Sequence[Mesh]) -> Fix | None:
    """Return the fix that gives each mesh its package:// address; None if the first mesh has none.

    The fix has no edits if an address is unknown, or if the source does not contain a file name literally.
    """
    right = [_right(mesh.file) if mesh.file else None for mesh in meshes]
    if not right[0]:
        return None
    edits = [Edit(mesh.at.span, address) for mesh, address in zip(meshes, right, strict=True) if address]
    is_sure = len(edits) == len(meshes) and all(mesh.at.span.text == mesh.filename for mesh in meshes)
    more = "; change the other meshes likewise" if len(meshes) > 1 else ""
    return Fix(f"write {right[0]}{more}", tuple(dict.fromkeys(edits)) if is_sure else ())


def _right(file: MeshFile) -> str | None:
    return file.meant or (file.address if file.exists else None)
