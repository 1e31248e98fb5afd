"""Copies of OBJ meshes that refer to no other file.

pybullet opens the material libraries that an OBJ names, and the textures that these name, wherever they are.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.smoke.engines.engine import RobotRejected
from urdfctl.smoke.engines.urdf import MOST_MESH_BYTES, quoted
from urdfctl.source.disk.files import first_bytes

_MESH = re.compile(r'(?i)(?<=<mesh filename=)"([^"]*\.obj)"')
_KEPT = (b"v", b"vn", b"vt", b"f", b"g", b"o", b"s")
_ENTITIES = (("&quot;", '"'), ("&gt;", ">"), ("&lt;", "<"), ("&amp;", "&"))


def with_own_meshes(urdf: str, folder: str) -> str:
    """Return a URDF of `prepare` with its OBJ meshes copied to a folder, without materials.

    Raises RobotRejected if a mesh cannot be read.
    """
    copies: dict[str, str] = {}

    def replaced(found: re.Match[str]) -> str:
        path = found[1]
        for entity, mark in _ENTITIES:
            path = path.replace(entity, mark)
        if path not in copies:
            copies[path] = _copied(path, os.path.join(folder, f"mesh{len(copies)}.obj"))
        return quoted(copies[path])

    return _MESH.sub(replaced, urdf)


def _copied(path: str, copy: str) -> str:
    try:
        data = first_bytes(path, MOST_MESH_BYTES)
    except OSError as error:
        raise RobotRejected(f"'{os.path.basename(path)}' cannot be read: {error.strerror}") from None
    with open(copy, "wb") as file:
        file.writelines(_without_materials(data))
    return copy


def _without_materials(data: bytes) -> Iterator[bytes]:
    """The lines of an OBJ that give its shape. Parts of other materials are groups: their hulls are made apart."""
    for line in data.splitlines():
        word, *rest = line.split(maxsplit=1) or [b""]
        if word in _KEPT:
            yield line + b"\n"
        elif word == b"usemtl":
            yield b"g %s\n" % (rest[0] if rest else b"none")
