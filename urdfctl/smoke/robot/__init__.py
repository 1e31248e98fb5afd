"""The robot in numbers: bodies, hinges and collision shapes, for the checks by formula and for the engines."""

from __future__ import annotations

from urdfctl.smoke.robot.collada import triangles_of_collada
from urdfctl.smoke.robot.description import hinges_of, mechanism_of, numbers_of, origin_of
from urdfctl.smoke.robot.loads import GRAVITY, gravity_load, moved_inertias, sampled_poses, worst_loads
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.rest_pose import TIPPED, TOUCHING, RestPose, carried_by, heights_of, rest_pose_of
from urdfctl.smoke.robot.shapes import Shape, Shapes, corners_of, is_endless, shapes_of, with_rims
from urdfctl.smoke.robot.ties import ties_of
from urdfctl.smoke.robot.wheels import GRIPS, LATERAL, LEVEL, SLIDES, Wheel, friction_of, is_wheel, wheels_of

__all__ = [
    "GRAVITY",
    "GRIPS",
    "LATERAL",
    "LEVEL",
    "SLIDES",
    "TIPPED",
    "TOUCHING",
    "Hinge",
    "LinkBody",
    "Mechanism",
    "RestPose",
    "Shape",
    "Shapes",
    "Wheel",
    "carried_by",
    "corners_of",
    "friction_of",
    "gravity_load",
    "heights_of",
    "hinges_of",
    "is_endless",
    "is_wheel",
    "mechanism_of",
    "moved_inertias",
    "numbers_of",
    "origin_of",
    "rest_pose_of",
    "sampled_poses",
    "shapes_of",
    "ties_of",
    "triangles_of_collada",
    "wheels_of",
    "with_rims",
    "worst_loads",
]
