"""Robots that crash engines, or that every engine rejects: each ends in a finding, in time, and no test crashes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from smoke_robots import ARMS, ROVERS, Arm, Rover, link
from smoking import checked, codes, smoked_in_workers, target_of, verdicts, whole
from smoking_engines import EACH_ENGINE, INSTALLED, needs_pybullet

from urdfctl.config.settings import Settings
from urdfctl.lint.job import job_for, perform_alone
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.run.limits import WorkerFailure
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.engines.engine import EngineSetup, RobotRejected, open_engine
from urdfctl.smoke.engines.urdf import mesh_fault
from urdfctl.smoke.motion.engine_workers import run_trial_job, without_meshes
from urdfctl.smoke.motion.plan import MotionPlan, SimulationResult
from urdfctl.smoke.motion.trial import run_trial
from urdfctl.smoke.results import RobotResult, Verdict
from urdfctl.smoke.robot_motion import with_engine_result
from urdfctl.smoke.run import SmokeRequest, load_and_judge

JAZZY = Settings(distro="jazzy")


def joint(name: str, parent: str, child: str) -> str:
    limit = '<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="10" velocity="1"/>'
    return (
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="0 0 0.2"/>{limit}</joint>'
    )


def body(*names: str) -> str:
    return "".join(link(name, 1.0, 0.01) for name in names)


def chain(count: int) -> str:
    links = body(*(f"l{n}" for n in range(count + 1)))
    return links + "".join(joint(f"j{n}", f"l{n}", f"l{n + 1}") for n in range(count))


def mesh(name: str) -> str:
    return Rover().urdf().replace('<box size="0.3 0.1 0.02"/>', f'<mesh filename="{name}"/>')


KILLERS = {
    "two roots": (body("a", "b"), "UC901"),
    "a cycle": (body("a", "b") + joint("j", "a", "b") + joint("k", "b", "a"), "UC901"),
    "a cycle beside a root": (
        body("r", "a", "b") + joint("j0", "r", "a") + joint("j", "a", "b") + joint("k", "b", "a"),
        "UC901",
    ),
    "a link twice": (body("a", "b", "b") + joint("j", "a", "b"), "UC901"),
    "a joint twice": (body("a", "b", "c") + joint("j", "a", "b") + joint("j", "b", "c"), "UC901"),
    "two parents": (body("a", "b", "c") + joint("j", "a", "c") + joint("k", "b", "c") + joint("m", "a", "b"), "UC901"),
    "its own parent": (body("r", "a") + joint("m", "r", "a") + joint("j", "a", "a"), "UC901"),
    "no number": ((body("a", "b") + joint("j", "a", "b")).replace('mass value="1.0"', 'mass value="nan"'), "UC910"),
    "an endless inertia": ((body("a", "b") + joint("j", "a", "b")).replace('ixx="0.01"', 'ixx="inf"'), "UC910"),
    "a chain of a thousand": (chain(1000), "UC921"),
    "a mesh with a bad corner": (mesh("bad.obj"), "UC922"),
    "a mesh that is not there": (mesh("package://nowhere/base.stl"), "UC922"),
    "a mesh cut short": (mesh("short.stl"), "UC922"),
    "a mesh of broken XML": (mesh("broken.dae"), "UC922"),
    "a mesh of another kind": (mesh("picture.glb"), "UC922"),
}
MESHES = {
    "bad.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999\nf -50 -60 -70\n",
    "empty.obj": b"",
    "short.stl": b"\0" * 80 + (4).to_bytes(4, "little") + b"\0" * 60,
    "words.stl": b"solid x\nfacet normal 0 0 1\nendsolid",
    "broken.dae": b"<COLLADA><lib",
    "bare.dae": b"<COLLADA/>",
    "picture.glb": b"glTF",
}  # fmt: skip


@pytest.mark.parametrize(("text", "code"), KILLERS.values(), ids=KILLERS)
@needs_pybullet
def test_a_robot_that_crashes_engines_ends_in_a_finding(tmp_path: Path, text: str, code: str) -> None:
    for name, data in MESHES.items():
        (tmp_path / name).write_bytes(data)
    urdf = text if "<robot" in text else f'<robot name="r">{text}</robot>'
    files = {"robot.urdf": urdf, "controllers.yaml": Rover().yaml()} if "wheel" in text else {"robot.urdf": urdf}
    [made] = smoked_in_workers([target_of(tmp_path, files)], [JAZZY], SmokeRequest(engines=("pybullet",)), 1)
    assert code in codes(made)
    assert "UC000" not in codes(made)


@needs_pybullet
def test_a_robot_with_too_many_joints_for_one_engine_is_simulated_in_the_other(tmp_path: Path) -> None:
    target = target_of(tmp_path, {"robot.urdf": f'<robot name="r">{chain(128)}</robot>'})
    [made] = smoked_in_workers([target], [JAZZY], SmokeRequest(engines=("pybullet",)), 1)
    assert codes(made) == ["UC921"]
    if "mujoco" in INSTALLED:
        [made] = smoked_in_workers([target], [JAZZY], SmokeRequest(engines=("pybullet",), instead=("mujoco",)), 1)
        assert (codes(made), made.engine) == ([], "mujoco")


@pytest.mark.parametrize("name", [name for name in MESHES if name != "picture.glb"])
def test_the_message_names_a_broken_mesh(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(MESHES[name])
    assert mesh_fault(str(path)).startswith(f"'{name}' ")


def test_sound_meshes_are_accepted(tmp_path: Path) -> None:
    sound = {
        "a.stl": b"\0" * 80 + (1).to_bytes(4, "little") + b"\0" * 50,
        "b.stl": b"solid x\nfacet normal 0 0 1\nvertex 0 0 0\n",
        "c.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "d.dae": b"<COLLADA><triangles/></COLLADA>",
    }
    for name, data in sound.items():
        (tmp_path / name).write_bytes(data)
        assert mesh_fault(str(tmp_path / name)) == ""
    assert "cannot be read" in mesh_fault(str(tmp_path / "none.stl"))


def test_an_enormous_mesh_is_ignored(tmp_path: Path) -> None:
    path = tmp_path / "large.stl"
    with path.open("wb") as file:
        file.truncate((20 << 20) + 1)
    assert mesh_fault(str(path)) == "'large.stl' is larger than 20 MiB"


# -- what workers pass on --------------------------------------------------------------------------------------------


def read(folder: Path, robot: Rover | Arm, *engines: str) -> CheckedRobot:
    target = target_of(folder, {"robot.urdf": robot.urdf(), "controllers.yaml": robot.yaml()})
    return checked(Loader(JAZZY), target, SmokeRequest(engines=engines or ("pybullet",)))


@pytest.mark.parametrize("robot", [ROVERS["large and heavy"], ARMS["joints that lift"]], ids=["rover", "arm"])
def test_a_prepared_robot_and_its_plan_survive_as_json(tmp_path: Path, robot: Rover | Arm) -> None:
    made = read(tmp_path, robot)
    again = CheckedRobot.from_json(json.loads(json.dumps(made.to_json())))
    assert again.plan == made.plan
    assert again.result.controllers == made.result.controllers
    assert again.placed == made.placed
    assert made.plan is not None
    assert MotionPlan.from_json(json.loads(json.dumps(made.plan.to_json()))) == made.plan


@needs_pybullet
def test_twice_is_the_same_and_survives_as_json(tmp_path: Path) -> None:
    made = read(tmp_path, Rover())
    assert made.plan is not None
    plan = made.plan._replace(engine="pybullet")
    first, second = run_trial(plan), run_trial(plan)
    assert first.curves == second.curves
    assert SimulationResult.from_json(json.loads(json.dumps(first._asdict()))) == first


def test_an_engine_that_crashes_is_reported_and_nothing_passes(tmp_path: Path) -> None:
    made = read(tmp_path, Rover())
    after = with_engine_result(made.result, made, "pybullet", WorkerFailure("the worker was ended by SIGSEGV"))
    assert codes(after) == ["UC920"]
    assert verdicts(after) == {"states": "skipped activate", "base": "skipped activate"}
    refused = with_engine_result(made.result, made, "pybullet", SimulationResult(refused="it says no"))
    assert codes(refused) == ["UC921"]
    assert {controller.reason for controller in refused.controllers} == {"not simulated: pybullet rejects the robot"}


def test_a_robot_is_tried_again_without_its_meshes(tmp_path: Path) -> None:
    plan = MotionPlan(
        "pybullet",
        '<a/>\n<collision><mesh filename="x.stl"/></collision>\n<b/>',
        read(tmp_path, Rover()).plan.mechanism,
        (),
        100.0,
        True,
    )  # type: ignore[union-attr]
    assert without_meshes(plan).urdf == "<a/>\n<b/>"
    assert without_meshes(plan).shapeless


@needs_pybullet
def test_a_worker_can_begin_with_a_job_alone(tmp_path: Path) -> None:
    target = target_of(tmp_path, {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml()})
    wanted = SmokeRequest(engines=("pybullet",))
    job = job_for(load_and_judge, target, JAZZY, details=wanted._asdict())
    made = perform_alone(json.loads(json.dumps(job)))
    plan = {**made["plan"], "engine": "pybullet"}
    import os

    kept, current = (os.dup(1), os.dup(2)), os.getcwd()
    try:
        result = run_trial_job({"plan": plan, "output": str(tmp_path / "output"), "live": False})
    finally:
        for number, descriptor in enumerate(kept, 1):
            os.dup2(descriptor, number)
            os.close(descriptor)
        os.chdir(current)
    assert result["moved"] == ("states", "base")


@needs_pybullet
def test_two_engines_move_a_robot_one_after_the_other(tmp_path: Path) -> None:
    target = target_of(tmp_path, {"robot.urdf": Rover().urdf(), "controllers.yaml": Rover().yaml()})
    [made] = smoked_in_workers([target], [JAZZY], SmokeRequest(engines=tuple(INSTALLED)), 1)
    assert made.engine == " and ".join(INSTALLED)
    assert made.count(Verdict.PASSED) == 2


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_an_engine_says_why_it_rejects_a_robot(engine: str) -> None:
    start = {f"j{n}": 0.0 for n in range(200)} if engine == "pybullet" else {}
    with pytest.raises(RobotRejected):
        open_engine(engine, EngineSetup("<robot name='r'><joint name='j'/></robot>", "base", True, start))


@needs_pybullet
def test_pybullet_rejects_a_file_that_is_not_urdf() -> None:
    with pytest.raises(RobotRejected, match=r"^Cannot load URDF file\.$"):
        open_engine("pybullet", EngineSetup("<robot>", "base", True, {}))


# -- single motions --------------------------------------------------------------------------------------------------


CONTROLLED = """
controller_manager:
  ros__parameters:
    update_rate: 250
    states: {{type: joint_state_broadcaster/JointStateBroadcaster}}
    mover: {{type: {kind}}}
mover:
  ros__parameters: {{{parameters}}}
"""


def by(
    folder: Path, kind: str, parameters: str, interface: str, arm: Arm | None = None, **limits: float
) -> RobotResult:
    """Return the smoke test of an arm with a controller of some type."""
    urdf = (arm or ARMS["joints that turn level"]).urdf(interface=interface, **limits)  # type: ignore[arg-type]
    yaml = CONTROLLED.format(kind=kind, parameters=parameters)
    return whole(target_of(folder, {"robot.urdf": urdf, "controllers.yaml": yaml}), "pybullet", distro="jazzy")


BOTH = "joints: [shoulder, elbow]"
PID = "dof_names: [elbow], command_interface: {}, reference_and_state_interfaces: [{}], gains: {{elbow: {{{}}}}}"
MOTIONS = {
    "positions": ("position_controllers/JointGroupPositionController", BOTH, "position"),
    "velocities": ("velocity_controllers/JointGroupVelocityController", BOTH, "velocity"),
    "efforts": ("effort_controllers/JointGroupEffortController", BOTH, "effort"),
    "forwarded": (
        "forward_command_controller/ForwardCommandController",
        f"{BOTH}, interface_name: velocity",
        "velocity",
    ),
    "a gripper": ("position_controllers/GripperActionController", "joint: elbow", "position"),
    "a position loop": ("pid_controller/PidController", PID.format("effort", "position", "p: 50.0, d: 3.0"), "effort"),
    "a velocity loop": ("pid_controller/PidController", PID.format("effort", "velocity", "p: 2.0, i: 1.0"), "effort"),
    "a trajectory of velocities": (
        "joint_trajectory_controller/JointTrajectoryController",
        (
            f"{BOTH}, command_interfaces: [velocity], state_interfaces: [position, velocity], "
            "gains: {shoulder: {p: 10.0, ff_velocity_scale: 1.0}, elbow: {p: 10.0}}"
        ),
        "velocity",
    ),
}


@needs_pybullet
@pytest.mark.parametrize(("kind", "parameters", "interface"), MOTIONS.values(), ids=MOTIONS)
def test_each_kind_of_controller_moves_its_joints(tmp_path: Path, kind: str, parameters: str, interface: str) -> None:
    made = by(tmp_path, kind, parameters, interface)
    assert [finding.message for finding in made.linted.outcome.diagnostics] == []
    assert verdicts(made)["mover"] == "passed deactivate"
    assert all(max(map(abs, curve.measured)) > 0.01 for curve in made.curves)


@needs_pybullet
@pytest.mark.parametrize("interfaces", ["position, velocity", "velocity, position", "position, velocity, acceleration"])
def test_a_trajectory_of_positions_and_velocities_commands_positions(tmp_path: Path, interfaces: str) -> None:
    claimed = "".join(f'<command_interface name="{name}"/>' for name in interfaces.split(", "))
    urdf = Arm().urdf(interface="position").replace('<command_interface name="position"/>', claimed)
    yaml = Arm().yaml(interface=interfaces).partition("    gains:")[0]
    made = whole(target_of(tmp_path, {"robot.urdf": urdf, "controllers.yaml": yaml}), distro="jazzy")
    assert codes(made) == []
    assert verdicts(made)["mover"] == "passed deactivate"


@needs_pybullet
def test_a_velocity_loop_of_the_wrong_sign_is_found(tmp_path: Path) -> None:
    parameters = PID.format("effort", "velocity", "p: -0.2")
    assert set(codes(by(tmp_path, "pid_controller/PidController", parameters, "effort"))) & {"UC935", "UC936"}


@needs_pybullet
def test_a_slow_joint_is_moved_no_faster_than_it_may(tmp_path: Path) -> None:
    made = by(tmp_path, *MOTIONS["positions"], velocity=0.02)
    assert codes(made) == []
    assert verdicts(made)["mover"] == "passed deactivate"
    assert max(abs(value) for curve in made.curves for value in curve.commanded) < 0.02


def test_a_controller_that_is_not_simulated_is_skipped_with_the_reason(tmp_path: Path) -> None:
    yaml = CONTROLLED.format(kind="acme_controllers/Wiggle", parameters=BOTH)
    urdf = ARMS["joints that turn level"].urdf()
    target = target_of(tmp_path, {"robot.urdf": urdf, "controllers.yaml": yaml})
    made = whole(target, INSTALLED[0], distro="jazzy") if INSTALLED else None
    if made:
        assert verdicts(made) == {"states": "passed deactivate", "mover": "skipped activate"}
        assert made.controllers[1].reason.startswith("not simulated: what it moves is unknown: describe ")


def test_a_robot_without_a_description_is_not_moved(tmp_path: Path) -> None:
    path = tmp_path / "controllers.yaml"
    path.write_text(Rover().yaml(), encoding="utf-8")
    made = checked(Loader(JAZZY), Target(str(path)), SmokeRequest(engines=("pybullet",)))
    assert made.plan is None


TWO = """
controller_manager:
  ros__parameters:
    update_rate: 500
    states: {{type: joint_state_broadcaster/JointStateBroadcaster}}
    first: {{type: pid_controller/PidController}}
    second: {{type: pid_controller/PidController}}
first:
  ros__parameters:
    {{dof_names: [shoulder], command_interface: effort, reference_and_state_interfaces: [position],
      gains: {{shoulder: {{{gains}}}}}}}
second:
  ros__parameters:
    {{dof_names: [elbow], command_interface: effort, reference_and_state_interfaces: [position],
      gains: {{elbow: {{{gains}}}}}}}
"""


@needs_pybullet
def test_loops_run_together_too(tmp_path: Path) -> None:
    urdf = ARMS["joints that turn level"].urdf()
    for gains, expected in (("p: 50.0, d: 3.0", False), ("p: 50.0, d: 0.0", True)):
        target = target_of(tmp_path, {"robot.urdf": urdf, "controllers.yaml": TWO.format(gains=gains)})
        assert ("UC934" in codes(whole(target, "pybullet", distro="jazzy"))) == expected


@needs_pybullet
def test_a_joint_that_mimics_follows(tmp_path: Path) -> None:
    urdf = ARMS["joints that turn level"].urdf(interface="position")
    before, mark, after = urdf.partition('<joint name="elbow" type="revolute">')
    mimicking = before + mark + after.replace("</joint>", '<mimic joint="shoulder" multiplier="-1"/></joint>', 1)
    mimicking = mimicking.replace('<joint name="elbow"><command_interface name="position"/>', '<joint name="elbow">')
    yaml = CONTROLLED.format(kind="position_controllers/JointGroupPositionController", parameters="joints: [shoulder]")
    made = whole(target_of(tmp_path, {"robot.urdf": mimicking, "controllers.yaml": yaml}), "pybullet", distro="jazzy")
    assert verdicts(made)["mover"] == "passed deactivate"
    assert codes(made) == []


TRICYCLE = """
controller_manager:
  ros__parameters:
    update_rate: 100
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    base: {type: tricycle_controller/TricycleController}
base:
  ros__parameters:
    traction_joint_name: front_wheel
    steering_joint_name: steering
    wheel_radius: 0.1
    wheelbase: 0.4
"""


def tricycle(steering: str = "0 0 1") -> str:
    """Return a tricycle, whose front wheel is driven and steered about an axis."""
    wheel = '<geometry><cylinder radius="0.1" length="0.04"/></geometry></collision></link>'

    def rear(name: str, y: float) -> str:
        shape = link(name, 0.5, 0.002).replace("</link>", f"<collision>{wheel}")
        return shape + (
            f'<joint name="{name}_wheel" type="continuous"><parent link="base_link"/><child link="{name}"/>'
            f'<origin xyz="-0.2 {y} 0" rpy="-1.5707963 0 0"/><axis xyz="0 0 1"/></joint>'
        )

    states = '<state_interface name="position"/><state_interface name="velocity"/>'
    front = link("front", 0.5, 0.002).replace("</link>", f"<collision>{wheel}")
    return f"""
    <robot name="tricycle">
      <link name="base_footprint"/>
      <joint name="foot" type="fixed"><parent link="base_footprint"/><child link="base_link"/></joint>
      {link("base_link", 5.0, 0.1, '<box size="0.4 0.1 0.02"/>', "0 0 0.05")}
      {rear("left", 0.15)}{rear("right", -0.15)}{link("fork", 0.5, 0.005)}{front}
      <joint name="steering" type="revolute"><parent link="base_link"/><child link="fork"/>
        <origin xyz="0.2 0 0"/><axis xyz="{steering}"/>
        <limit lower="-1.5" upper="1.5" effort="50" velocity="5"/></joint>
      <joint name="front_wheel" type="continuous"><parent link="fork"/><child link="front"/>
        <origin rpy="-1.5707963 0 0"/><axis xyz="0 0 1"/><limit effort="20" velocity="30"/></joint>
      <ros2_control name="wheels" type="system">
        <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="steering"><command_interface name="position"/>{states}</joint>
        <joint name="front_wheel"><command_interface name="velocity"/>{states}</joint>
      </ros2_control>
    </robot>
    """


@needs_pybullet
def test_a_tricycle_steers_to_the_left_and_a_fork_upside_down_is_found(tmp_path: Path) -> None:
    for axis, expected in (("0 0 1", []), ("0 0 -1", ["UC942", "UC961"])):
        target = target_of(tmp_path, {"robot.urdf": tricycle(axis), "controllers.yaml": TRICYCLE})
        assert codes(whole(target, "pybullet", distro="jazzy")) == expected


@needs_pybullet
def test_a_rover_whose_shapes_are_missing_is_not_called_faulty(tmp_path: Path) -> None:
    urdf = Rover().urdf().replace('<sphere radius="0.05"/>', '<mesh filename="package://gone/ball.stl"/>')
    balanced = urdf.replace('xyz="0 0.15 0"', 'xyz="0.3 0.15 0"').replace('xyz="0 -0.15 0"', 'xyz="0.3 -0.15 0"')
    balanced = balanced.replace('xyz="0 0 0.05"', 'xyz="0 0 0.3"')
    target = target_of(tmp_path, {"robot.urdf": balanced, "controllers.yaml": Rover().yaml()})
    made = whole(target, "pybullet", distro="jazzy")
    assert codes(made) == ["UC922"]
    assert made.controllers[1].reason == "not simulated: collision geometry under the robot is missing"


@needs_pybullet
def test_a_simulation_that_explodes_is_reported(tmp_path: Path) -> None:
    arm = ARMS["joints that turn level"]
    target = target_of(
        tmp_path, {"robot.urdf": arm.urdf(effort=1e30), "controllers.yaml": arm.yaml("p: 1.0e+20, d: 1.0e+20")}
    )
    assert {"UC916", "UC930", "UC933", "UC936"} & set(codes(whole(target, "pybullet", distro="jazzy")))


MECANUM = """
controller_manager:
  ros__parameters:
    update_rate: 100
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    base: {type: mecanum_drive_controller/MecanumDriveController}
base:
  ros__parameters:
    front_left_wheel_command_joint_name: left_wheel
    front_right_wheel_command_joint_name: right_wheel
    rear_left_wheel_command_joint_name: left_back_wheel
    rear_right_wheel_command_joint_name: right_back_wheel
    kinematics:
      base_frame_offset: {x: 0.0, y: 0.0, theta: 0.0}
      wheels_radius: 0.1
      sum_of_robot_center_projection_on_X_Y_axis: 0.25
    base_frame_id: base_link
"""


def four_wheeled(right: str) -> str:
    """Return a rover with two more wheels at the back, and some axes of the right wheels."""
    urdf = Rover().urdf(right=right)
    more = []
    for name, y, axis in (("left_back", 0.15, "0 0 1"), ("right_back", -0.15, right)):
        more.append(
            link(name, 0.5, 0.002, '<cylinder radius="0.1" length="0.04"/>')
            + f'<joint name="{name}_wheel" type="continuous"><parent link="base_link"/><child link="{name}"/>'
            + f'<origin xyz="-0.2 {y} 0" rpy="-1.5707963 0 0"/><axis xyz="{axis}"/></joint>'
        )
    states = '<state_interface name="position"/><state_interface name="velocity"/>'
    controls = "".join(
        f'<joint name="{name}_back_wheel"><command_interface name="velocity"/>{states}</joint>'
        for name in ("left", "right")
    )
    return urdf.replace("<ros2_control", "".join(more) + "<ros2_control").replace(
        "</ros2_control>", f"{controls}</ros2_control>"
    )


@needs_pybullet
def test_mecanum_wheels_turn_in_the_air(tmp_path: Path) -> None:
    for axis, expected in (("0 0 1", []), ("0 0 -1", ["UC912"])):
        target = target_of(tmp_path, {"robot.urdf": four_wheeled(axis), "controllers.yaml": MECANUM})
        made = whole(target, "pybullet", distro="jazzy")
        assert codes(made) == expected
        assert verdicts(made)["base"] == ("failed move" if expected else "passed deactivate")


@needs_pybullet
def test_efforts_push_one_joint_at_a_time(tmp_path: Path) -> None:
    kind, parameters, interface = MOTIONS["efforts"]
    made = by(tmp_path, kind, parameters, interface, ARMS["joints that lift"])
    assert codes(made) == []
    assert [(curve.joint, curve.seconds[-1]) for curve in made.curves] == [("shoulder", 0.2), ("elbow", 0.2)]


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_an_engine_leaves_nothing_behind(tmp_path: Path, engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    arm = ARMS["joints that turn level"]
    files = {"robot.urdf": arm.urdf(effort=1e30), "controllers.yaml": arm.yaml("p: 1.0e+12, d: 1.0e+12")}
    target = target_of(tmp_path / "robot", files)
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    assert "UC916" in codes(whole(target, engine, distro="jazzy"))
    assert list((tmp_path / "here").iterdir()) == []


@pytest.mark.parametrize("engine", EACH_ENGINE)
def test_links_without_gravity_are_carried(tmp_path: Path, engine: str) -> None:
    arm = ARMS["joints that slide up"]
    off = "".join(f'<gazebo reference="{name}"><gravity>0</gravity></gazebo>' for name in ("upper", "fore"))
    weak = arm.urdf(effort=20.0).replace("</robot>", f"{off}</robot>")
    target = target_of(tmp_path, {"robot.urdf": weak, "controllers.yaml": arm.yaml()})
    assert codes(whole(target, engine, distro="jazzy")) == []
