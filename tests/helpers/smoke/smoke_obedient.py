"""An engine without physics, whose joints go where they are told, and the trial of a robot in it."""

from __future__ import annotations

from urdfctl.model.geometry import Pose
from urdfctl.smoke.engines.engine import STEP, BasePose
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.trial import MotionTrial
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask


class Obedient:
    """An engine whose joints reach every command at once, and whose base drives as two wheels roll it."""

    def __init__(
        self, *, off: float = 0.0, touching: frozenset[str] = frozenset({"lw", "rw"}), roll: float = 0.0
    ) -> None:
        self.off, self.ground, self.roll = off, touching, roll
        self.places: dict[str, float] = {}
        self.speeds: dict[str, float] = {}
        self.x = self.yaw = 0.0

    def position(self, joint: str) -> float:
        return self.places.get(joint, 0.0) + (self.off if joint == "follower" else 0.0)

    def velocity(self, joint: str) -> float:
        return self.speeds.get(joint, 0.0) + (self.off if joint == "follower" else 0.0)

    def effort(self, joint: str) -> float:
        return 0.0

    def place(self, joint: str, position: float) -> None:
        self.places[joint], self.speeds[joint] = position, 0.0

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        assert effort >= 0 <= velocity
        self.places[joint] = position

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        assert effort >= 0
        self.speeds[joint] = velocity

    def with_effort(self, joint: str, effort: float) -> None:
        self.places[joint] = effort

    def step(self) -> None:
        left, right = (0.1 * self.speeds.get(name, 0.0) for name in ("l", "r"))
        self.x += 0.0005 * (left + right)
        for name in ("l", "r"):
            self.places[name] = self.places.get(name, 0.0) + 0.001 * self.speeds.get(name, 0.0)
        self.yaw += 0.001 * (right - left) / 0.4

    def base_pose(self) -> BasePose:
        return BasePose(self.x, 0.0, 0.0, self.roll, 0.0, self.yaw)

    def touching(self) -> set[str]:
        return set(self.ground)

    def close(self) -> None:
        pass


class Late(Obedient):
    """An engine whose joints come to each commanded position after some seconds."""

    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.steps_behind = round(seconds / STEP)
        self.before: list[dict[str, float]] = []

    def step(self) -> None:
        super().step()
        self.before.append(dict(self.places))

    def position(self, joint: str) -> float:
        n = len(self.before) - 1 - self.steps_behind
        return self.before[n].get(joint, 0.0) if n >= 0 else 0.0


def hinge(name: str, child: str, **fields: object) -> Hinge:
    made = Hinge(
        name, "revolute", "base", child, Pose(), (0.0, 1.0, 0.0), lower=-1.0, upper=1.0, effort=10.0, velocity=1.0
    )
    return made._replace(**fields)  # type: ignore[arg-type]


def trial(
    obedient: Obedient, hinges: tuple[Hinge, ...], tasks: tuple[ControllerTask, ...], **fields: object
) -> MotionTrial:
    bodies = {name: LinkBody(name) for name in ("base", *(one.child for one in hinges))}
    plan = MotionPlan("mujoco", "", Mechanism("base", bodies, hinges), tasks, 100.0, fixed=True)._replace(**fields)  # type: ignore[arg-type]
    made = MotionTrial(plan, obedient, (), 0.0 if fields.get("budget") == 0.0 else 1e9)
    made.run()
    return made
