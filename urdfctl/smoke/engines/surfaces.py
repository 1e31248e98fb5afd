"""The collision geometry of a robot as MoveIt tests it: meshes as the surfaces that they are, in FCL.

MuJoCo collides the convex hulls of meshes, and finds those that touch in a fraction of the time. Only these are tested
here, because meshes can only touch where their hulls do.
"""

from __future__ import annotations

from importlib.util import find_spec
from typing import Any

from urdfctl.source.disk.files import first_bytes

_MOST_BYTES = 20 << 20
TIE = 1e-7
"""Shapes that are as near as this, in m, touch in some poses: of faces that meet exactly, each is rounded otherwise.

It is about the precision of a mesh of 1 m in an STL file, and in MuJoCo."""


def tests_surfaces() -> bool:
    """Return whether FCL is installed."""
    return find_spec("fcl") is not None


class Surfaces:
    """The shapes of a compiled model of MuJoCo, in FCL."""

    def __init__(self, library: Any, model: Any, tie: float) -> None:
        import fcl

        self._library, self._model, self._fcl, self._tie = library, model, fcl, tie
        self._meshes: dict[int, Any] = {}
        self._objects: dict[int, Any] = {}

    def meet(self, data: Any, one: int, other: int) -> bool:
        """Return whether two shapes touch, given that their hulls do."""
        mesh = self._library.mjtGeom.mjGEOM_MESH
        if mesh not in (self._model.geom_type[one], self._model.geom_type[other]):
            return True
        both = self._placeable(one), self._placeable(other)
        if None in both:
            return True
        for shape, placed in zip((one, other), both, strict=True):
            turn, place = data.geom_xmat[shape].reshape(3, 3), data.geom_xpos[shape]
            placed.setTransform(self._fcl.Transform(turn, place))
        return bool(self._fcl.collide(*both, self._fcl.CollisionRequest(), self._fcl.CollisionResult()))

    def _placeable(self, shape: int) -> Any:
        """A shape in FCL, made when it is first needed: trees of large meshes take long, and many never touch."""
        if shape not in self._objects:
            self._objects[shape] = self._object(shape)
        return self._objects[shape]

    def _object(self, shape: int) -> Any:
        """A shape in FCL; None for one of a kind that a URDF does not have."""
        kinds, size = self._library.mjtGeom, self._model.geom_size[shape].tolist()
        kind = self._model.geom_type[shape]
        if kind == kinds.mjGEOM_MESH:
            made = self._mesh(int(self._model.geom_dataid[shape]))
        elif kind == kinds.mjGEOM_BOX:
            made = self._fcl.Box(*(2 * half for half in size))
        elif kind == kinds.mjGEOM_SPHERE:
            made = self._fcl.Sphere(size[0])
        elif kind == kinds.mjGEOM_CYLINDER:
            made = self._fcl.Cylinder(size[0], 2 * size[1])
        else:
            return None
        return self._fcl.CollisionObject(made, self._fcl.Transform())

    def _mesh(self, number: int) -> Any:
        if number not in self._meshes:
            model = self._model
            first, count = int(model.mesh_vertadr[number]), int(model.mesh_vertnum[number])
            start, triangles = int(model.mesh_faceadr[number]), int(model.mesh_facenum[number])
            made = self._fcl.BVHModel()
            made.beginModel(count, triangles)
            faces = model.mesh_face[start : start + triangles]
            corners = model.mesh_vert[first : first + count].astype(float)
            made.addSubModel(_grown(corners, faces, self._tie), faces)
            made.endModel()
            self._meshes[number] = made
        return self._meshes[number]


def _grown(corners: Any, faces: Any, by: float) -> Any:
    """The corners of a mesh, moved outwards."""
    import numpy as np

    one, two, three = (corners[faces[:, n]] for n in range(3))
    outwards = np.zeros_like(corners)
    for n in range(3):
        np.add.at(outwards, faces[:, n], np.cross(two - one, three - one))
    lengths = np.linalg.norm(outwards, axis=1, keepdims=True)
    return corners + by * outwards / np.where(lengths > 0, lengths, 1.0)


def read_surface(mesh: Any) -> bool:
    """Give MuJoCo the triangles of a mesh that it cannot read; return whether it now has them."""
    from urdfctl.smoke.robot import triangles_of_collada

    if not mesh.file.lower().endswith(".dae"):
        return False
    points, faces = triangles_of_collada(first_bytes(mesh.file, _MOST_BYTES))
    if not faces:
        return False
    mesh.uservert = [part for point in points for part in point]
    mesh.userface = [corner for face in faces for corner in face]
    mesh.file = ""
    return True
