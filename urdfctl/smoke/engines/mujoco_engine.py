"""MuJoCo: the second engine. It accepts any number of joints, never crashes, and names the element that it rejects.

It has no motors for a URDF. A joint is driven by the effort that accelerates its own inertia and carries its weight, up
to its effort limit.
"""

from __future__ import annotations

import math
import os
from typing import Any

from urdfctl.smoke.engines import quick_mujoco
from urdfctl.smoke.engines.engine import STEP, BasePose, EngineSetup, Motor, RobotRejected
from urdfctl.smoke.engines.mujoco_drives import EFFORT, POSITION, VELOCITY, Drives
from urdfctl.smoke.engines.urdf import quoted
from urdfctl.smoke.robot import corners_of

GROUND = "urdfctl:ground"
_LEAST_CORNERS = 4
COMPILER = (
    '<mujoco><compiler balanceinertia="true" boundmass="1e-6" boundinertia="1e-9" discardvisual="true" '
    'strippath="false" fusestatic="false"/></mujoco>'
)


class MujocoEngine:
    """A robot in MuJoCo."""

    def __init__(self, library: Any, model: Any, data: Any, root: str) -> None:
        self._library, self._model, self._data = library, model, data
        self._root = library.mj_name2id(model, library.mjtObj.mjOBJ_BODY, root)
        kinds = library.mjtObj
        names = {n: library.mj_id2name(model, kinds.mjOBJ_JOINT, n) for n in range(model.njnt)}
        moving = [n for n in names if not names[n].startswith(GROUND)]
        self._places = {names[n]: int(model.jnt_qposadr[n]) for n in moving}
        self._ways = {names[n]: int(model.jnt_dofadr[n]) for n in moving}
        self._drives = Drives(model, data, {way: self._places[name] for name, way in self._ways.items()})
        # lists of the engine's arrays, whose numbers are read one by one: from an array that takes five times as long
        self._at: list[float] = []
        self._moving: list[float] = []

    def _read(self) -> None:
        """Take the positions and velocities that the engine has now."""
        self._at, self._moving = self._data.qpos.tolist(), self._data.qvel.tolist()

    def prepare(self, setup: EngineSetup) -> None:
        """Set the start positions, and place the robot on the ground."""
        ways = self._ways
        self._drives.add_motors({ways[name]: Motor(*given) for name, given in setup.resist.items() if name in ways})
        for name, position in setup.start.items():
            if name in self._places:
                self._data.qpos[self._places[name]] = position
        self._library.mj_forward(self._model, self._data)
        if not setup.fixed:
            self._put_down()
        self._read()

    def _put_down(self) -> None:
        model, data = self._model, self._data
        lowest = []
        for shape in range(model.ngeom):
            if int(model.geom_bodyid[shape]) == 0:
                continue
            lowest.append(float(data.geom_xpos[shape][2]) - self._reach_down(shape))
        data.qpos[2] -= min(lowest, default=0.0) - 0.001
        self._library.mj_forward(model, data)

    def _reach_down(self, shape: int) -> float:
        """How far a shape reaches below its origin as it is turned, in m."""
        model, kinds = self._model, self._library.mjtGeom
        up = self._data.geom_xmat[shape].reshape(3, 3)[2]
        kind, size, mesh = int(model.geom_type[shape]), model.geom_size[shape], int(model.geom_dataid[shape])
        if kind == kinds.mjGEOM_SPHERE:
            return float(size[0])
        if kind == kinds.mjGEOM_CYLINDER:
            return float(size[0] * math.hypot(up[0], up[1]) + size[1] * abs(up[2]))
        if kind == kinds.mjGEOM_MESH:
            first = int(model.mesh_vertadr[mesh])
            return -float((model.mesh_vert[first : first + int(model.mesh_vertnum[mesh])] @ up).min())
        box = model.geom_aabb[shape]
        return float(abs(up) @ box[3:] - up @ box[:3])

    def position(self, joint: str) -> float:
        """Return the position of a joint, in rad or m."""
        return self._at[self._places[joint]]

    def velocity(self, joint: str) -> float:
        """Return the velocity of a joint, in rad/s or m/s."""
        return self._moving[self._ways[joint]]

    def effort(self, joint: str) -> float:
        """Return the effort with which its motor drove a joint in the last step, in N m or N."""
        return self._drives.effort(self._ways[joint])

    def place(self, joint: str, position: float) -> None:
        """Put a joint at a position, at rest."""
        way = self._ways[joint]
        self._data.qpos[self._places[joint]] = position
        for changing in (self._data.qvel, self._data.qacc_warmstart, self._data.qfrc_applied):
            changing[way] = 0.0
        self._read()

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        """Drive a joint to a position, with a maximum effort and velocity."""
        self._drives.command(self._ways[joint], POSITION, position, effort, velocity)

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        """Drive a joint at a velocity, with a maximum effort."""
        self._drives.command(self._ways[joint], VELOCITY, velocity, effort, math.inf)

    def with_effort(self, joint: str, effort: float) -> None:
        """Push a joint with an effort, in N m or N."""
        self._drives.command(self._ways[joint], EFFORT, effort, math.inf, math.inf)

    def step(self) -> None:
        """Simulate STEP seconds."""
        self._drives.apply()
        self._library.mj_step(self._model, self._data)
        self._read()

    def base_pose(self) -> BasePose:
        """Return the place and rotation of the base."""
        x, y, z = (float(part) for part in self._data.xpos[self._root])
        turn = self._data.xmat[self._root].reshape(3, 3)
        roll = math.atan2(turn[2, 1], turn[2, 2])
        pitch = math.asin(max(-1.0, min(1.0, -turn[2, 0])))
        return BasePose(x=x, y=y, z=z, roll=roll, pitch=pitch, yaw=math.atan2(turn[1, 0], turn[0, 0]))

    def touching(self) -> set[str]:
        """Return the links that touch the ground."""
        library, model = self._library, self._model
        touching = set()
        for contact in self._data.contact:
            bodies = [int(model.geom_bodyid[shape]) for shape in contact.geom]
            if 0 in bodies:
                touching |= {library.mj_id2name(model, library.mjtObj.mjOBJ_BODY, body) for body in bodies if body}
        return touching

    def close(self) -> None:
        """Do nothing: MuJoCo keeps nothing open."""


def open_engine(setup: EngineSetup) -> MujocoEngine:
    """Return a robot in MuJoCo. Raise RobotRejected with the element that MuJoCo names if it rejects the robot."""
    mujoco = quick_mujoco.load()
    # by default it writes MUJOCO_LOG.TXT to the working directory
    mujoco.set_mju_user_warning(lambda _: None)
    above = f'<link name="{GROUND}"/><joint name="{GROUND}" type="fixed"><parent link="{GROUND}"/>'
    above += f"<child link={quoted(setup.root)}/></joint>"
    text = setup.urdf.replace('<robot name="robot">', f'<robot name="robot">{COMPILER}{above}', 1)
    try:
        spec = mujoco.MjSpec.from_string(text)
        spec.option.timestep = STEP
        spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC  # the pyramidal cone lets wheels slip sideways
        if not setup.fixed:
            _set_free(mujoco, spec.body(setup.root))
            spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1])
        for shape in spec.geoms:
            ground = shape.parent == spec.worldbody
            shape.contype, shape.conaffinity = (2, 1) if ground else (1, 2)
            wheel = shape.parent.name in setup.wheels
            # of two surfaces MuJoCo takes the greater friction
            shape.friction[0] = 0.0 if ground else setup.friction_of(shape.parent.name)
            if wheel and shape.type == mujoco.mjtGeom.mjGEOM_CYLINDER:
                shape.type = mujoco.mjtGeom.mjGEOM_SPHERE  # the edges of a cylinder shake the robot
        for mesh in spec.meshes:
            read_mesh(mesh)
        for name in setup.weightless:
            spec.body(name).gravcomp = 1.0
        model = spec.compile()
    except (ValueError, AttributeError) as error:
        raise RobotRejected(str(error).strip()) from None
    engine = MujocoEngine(mujoco, model, mujoco.MjData(model), setup.root)
    engine.prepare(setup)
    return engine


def read_mesh(mesh: Any) -> None:
    """Give MuJoCo the corners of a mesh that it cannot read; it collides their convex hull, as of any mesh."""
    if not mesh.file.lower().endswith(".dae"):
        return
    corners = corners_of(mesh.file)
    if len(corners) < _LEAST_CORNERS:
        raise RobotRejected(f"'{os.path.basename(mesh.file)}' has no corners that urdfctl can read")
    mesh.uservert = [part for corner in corners for part in corner]
    mesh.file = ""


def _set_free(library: Any, body: Any) -> None:
    """Let a body move freely: its coordinates begin with three slide joints, followed by a ball joint."""
    for axis, way in zip("xyz", ((1, 0, 0), (0, 1, 0), (0, 0, 1)), strict=True):
        body.add_joint(name=f"{GROUND}:{axis}", type=library.mjtJoint.mjJNT_SLIDE, axis=way)
    body.add_joint(name=f"{GROUND}:turn", type=library.mjtJoint.mjJNT_BALL)
