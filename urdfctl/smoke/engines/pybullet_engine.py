"""pybullet: the preferred engine for wheeled robots, and the one that starts faster."""

from __future__ import annotations

import math
import os
import time
from typing import Any

from urdfctl.output.scratch import scratch_folder
from urdfctl.smoke.engines.engine import FREE_MOTOR, STEP, BasePose, EngineSetup, Motor, RobotRejected
from urdfctl.smoke.engines.obj_meshes import with_own_meshes
from urdfctl.smoke.robot import SLIDES

MOST_JOINTS = 121
"""The maximum number of movable joints: of the 128 coordinates that pybullet keeps of a robot (MAX_DEGREE_OF_FREEDOM),
7 are those of its base. It ignores commands to joints beyond, and calls their positions 0."""


class PybulletEngine:
    """A robot in pybullet."""

    def __init__(self, physics: Any, client: int, robot: int, plane: int | None) -> None:
        self._physics, self._client, self._robot, self._plane = physics, client, robot, plane
        self._joints: dict[str, int] = {}
        self._links: dict[int, str] = {}
        self._root = physics.getBodyInfo(robot, physicsClientId=client)[0].decode("utf-8", "replace")
        for index in range(physics.getNumJoints(robot, physicsClientId=client)):
            info = physics.getJointInfo(robot, index, physicsClientId=client)
            self._links[index] = info[12].decode("utf-8", "replace")
            if info[2] in (physics.JOINT_REVOLUTE, physics.JOINT_PRISMATIC):
                self._joints[info[1].decode("utf-8", "replace")] = index
        self._pushed: dict[int, float] = {}
        self._motors: dict[int, Motor] = {}
        self._commands: dict[int, tuple[str, float, float, float]] = {}
        self._pause = 0.0
        self._carried: dict[int, float] = {}

    def prepare(self, setup: EngineSetup) -> None:
        """Set the start positions, and remove what pybullet adds by default: motors, damping, velocity limits."""
        physics, robot, client = self._physics, self._robot, self._client
        self._pause = STEP if setup.gui else 0.0
        for index in (-1, *self._links):
            link = self._links.get(index, self._root)
            physics.changeDynamics(
                robot,
                index,
                linearDamping=0,
                angularDamping=0,
                maxJointVelocity=math.inf,
                physicsClientId=client,
            )
            # with the other values in one call, pybullet ignores the friction
            friction = setup.friction_of(link)
            physics.changeDynamics(robot, index, lateralFriction=friction, physicsClientId=client)
            if link in setup.skidding:  # it would not let the wheels slip, so that the base does not turn
                ways = [1 - (1 - SLIDES) * abs(part) for part in setup.skidding[link]]
                physics.changeDynamics(robot, index, anisotropicFriction=ways, physicsClientId=client)
        for name, index in self._joints.items():
            physics.resetJointState(robot, index, setup.start.get(name, 0.0), physicsClientId=client)
            self._motor(index, 0.0, 0.0)
            if name in setup.stiff:
                physics.changeDynamics(robot, index, jointDamping=0.0, physicsClientId=client)
            if name in setup.resist:
                self._motors[index] = Motor(*setup.resist[name])
        for index, name in self._links.items():
            if name in setup.weightless:
                self._carried[index] = 9.81 * physics.getDynamicsInfo(robot, index, physicsClientId=client)[0]
        if self._plane is not None:
            self._put_down()

    def _put_down(self) -> None:
        """Place the robot so that its lowest point is 1 mm above the ground."""
        physics, robot, client = self._physics, self._robot, self._client
        bounds = [
            physics.getAABB(robot, index, physicsClientId=client)[0][2]
            for index in (-1, *self._links)
            if physics.getCollisionShapeData(robot, index, physicsClientId=client)
        ]
        place, turn = physics.getBasePositionAndOrientation(robot, physicsClientId=client)
        lowest = min(bounds, default=place[2])
        lifted = (place[0], place[1], place[2] - lowest + 0.001)
        physics.resetBasePositionAndOrientation(robot, lifted, turn, physicsClientId=client)

    def _motor(self, index: int, velocity: float, effort: float) -> None:
        self._physics.setJointMotorControl2(
            self._robot,
            index,
            self._physics.VELOCITY_CONTROL,
            targetVelocity=velocity,
            force=effort,
            physicsClientId=self._client,
        )

    def position(self, joint: str) -> float:
        """Return the position of a joint, in rad or m."""
        state = self._physics.getJointState(self._robot, self._joints[joint], physicsClientId=self._client)
        return float(state[0])

    def velocity(self, joint: str) -> float:
        """Return the velocity of a joint, in rad/s or m/s."""
        state = self._physics.getJointState(self._robot, self._joints[joint], physicsClientId=self._client)
        return float(state[1])

    def effort(self, joint: str) -> float:
        """Return the effort with which its motor drove a joint in the last step, in N m or N."""
        index = self._joints[joint]
        if index in self._pushed:
            return self._pushed[index]
        return float(self._physics.getJointState(self._robot, index, physicsClientId=self._client)[3])

    def place(self, joint: str, position: float) -> None:
        """Put a joint at a position, at rest."""
        self._physics.resetJointState(self._robot, self._joints[joint], position, physicsClientId=self._client)

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        """Drive a joint to a position, with a maximum effort and velocity."""
        index = self._joints[joint]
        self._pushed.pop(index, None)
        if index in self._motors:
            self._commands[index] = "position", position, effort, velocity
        self._to_position(index, position, effort, velocity)

    def _to_position(self, index: int, position: float, effort: float, velocity: float) -> None:
        self._physics.setJointMotorControl2(
            self._robot,
            index,
            self._physics.POSITION_CONTROL,
            targetPosition=position,
            force=effort,
            maxVelocity=velocity,
            physicsClientId=self._client,
        )

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        """Drive a joint at a velocity, with a maximum effort."""
        index = self._joints[joint]
        self._pushed.pop(index, None)
        if index in self._motors:
            self._commands[index] = "velocity", velocity, effort, math.inf
        self._motor(index, velocity, effort)

    def with_effort(self, joint: str, effort: float) -> None:
        """Push a joint with an effort, in N m or N."""
        index = self._joints[joint]
        if index not in self._pushed:
            self._commands.pop(index, None)
            # a motor that holds the velocity 0 with a small effort is the friction
            self._motor(index, 0.0, self._motors.get(index, FREE_MOTOR).friction)
        self._pushed[index] = effort

    def _drive(self, index: int, kind: str, value: float, effort: float, most: float) -> None:
        """Command a motor for one step, with what friction and damping leave of its effort."""
        place, velocity = self._physics.getJointState(self._robot, index, physicsClientId=self._client)[:2]
        motor = self._motors[index]
        top = motor.top(effort)
        if kind == "velocity":
            wanted = max(-top, min(top, value))
            self._motor(index, wanted, motor.left(effort, wanted, velocity))
        else:
            left = motor.left(effort, math.copysign(math.inf, value - place), velocity)
            self._to_position(index, value, left, min(most, top))

    def step(self) -> None:
        """Simulate STEP seconds. In pybullet an effort lasts for one step, so it is applied at each step."""
        physics, robot, client = self._physics, self._robot, self._client
        for driven, command in self._commands.items():
            self._drive(driven, *command)
        if self._pushed:
            physics.setJointMotorControlArray(
                robot,
                list(self._pushed),
                physics.TORQUE_CONTROL,
                forces=list(self._pushed.values()),
                physicsClientId=client,
            )
        for index, weight in self._carried.items():
            place = physics.getLinkState(robot, index, physicsClientId=client)[0]
            up = (0.0, 0.0, weight)
            physics.applyExternalForce(robot, index, up, place, physics.WORLD_FRAME, physicsClientId=client)
        physics.stepSimulation(physicsClientId=client)
        if self._pause:
            time.sleep(self._pause)

    def base_pose(self) -> BasePose:
        """Return the place and rotation of the base."""
        place, turn = self._physics.getBasePositionAndOrientation(self._robot, physicsClientId=self._client)
        return BasePose(*place, *self._physics.getEulerFromQuaternion(turn))

    def touching(self) -> set[str]:
        """Return the links that touch the ground."""
        contacts = self._physics.getContactPoints(self._robot, self._plane, physicsClientId=self._client)
        return {self._links.get(contact[3], self._root) for contact in contacts or ()}

    def close(self) -> None:
        """End the simulation."""
        self._physics.disconnect(physicsClientId=self._client)


def open_engine(setup: EngineSetup) -> PybulletEngine:
    """Return a robot in pybullet. Raise RobotRejected if pybullet rejects it."""
    if len(setup.start) > MOST_JOINTS:
        raise RobotRejected(f"it has {len(setup.start)} movable joints, and the limit is {MOST_JOINTS}")
    import pybullet

    client = pybullet.connect(pybullet.GUI if setup.gui else pybullet.DIRECT)
    pybullet.setGravity(0, 0, -9.81, physicsClientId=client)
    pybullet.setTimeStep(STEP, physicsClientId=client)
    plane = None
    if not setup.fixed:
        shape = pybullet.createCollisionShape(pybullet.GEOM_PLANE, physicsClientId=client)
        plane = pybullet.createMultiBody(0, shape, physicsClientId=client)
        pybullet.changeDynamics(plane, -1, lateralFriction=1.0, physicsClientId=client)
    # a new file name each time: pybullet caches files by name
    with scratch_folder() as folder:
        path = os.path.join(folder, "robot.urdf")
        with open(path, "w", encoding="utf-8") as file:
            file.write(with_own_meshes(setup.urdf, folder))
        flags = pybullet.URDF_USE_INERTIA_FROM_FILE | pybullet.URDF_IGNORE_VISUAL_SHAPES
        try:
            robot = pybullet.loadURDF(path, useFixedBase=setup.fixed, flags=flags, physicsClientId=client)
        except pybullet.error as error:
            pybullet.disconnect(physicsClientId=client)
            raise RobotRejected(str(error)) from None
    engine = PybulletEngine(pybullet, client, robot, plane)
    engine.prepare(setup)
    return engine
