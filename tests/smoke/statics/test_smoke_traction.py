"""The grip of wheels on the ground: what `<gazebo>` says of it, by formula, and in both engines."""

from __future__ import annotations

from pathlib import Path

import pytest
from smoke_robots import Rover
from smoking import codes, smoked, target_of, whole
from smoking_engines import EACH_ENGINE

from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.statics.ground import shares_of

ROVER = Rover()


def surface(friction: str, *links: str) -> str:
    """Return the rover with some friction of some links."""
    elements = "".join(f'<gazebo reference="{link}">{friction}</gazebo>' for link in links)
    return ROVER.urdf().replace("</robot>", f"{elements}</robot>")


def mu(value: float) -> str:
    return f"<mu1>{value}</mu1><mu2>{value}</mu2>"


def run(folder: Path, urdf: str, engine: str | None = None) -> RobotResult:
    target = target_of(folder, {"robot.urdf": urdf, "controllers.yaml": ROVER.yaml()})
    return whole(target, engine, distro="jazzy") if engine else smoked(target, distro="jazzy")


@pytest.mark.parametrize(
    ("places", "shares"),
    [
        ([(1, 1), (1, -1), (-1, 1), (-1, -1)], [0.25, 0.25, 0.25, 0.25]),
        ([(3, 0), (-1, 0)], [0.25, 0.75]),
        ([(2, 0), (-1, 1), (-1, -1)], [1 / 3, 1 / 3, 1 / 3]),
        ([(1, 0), (1, 1), (1, -1)], [1 / 3, 1 / 3, 1 / 3]),
        ([(0, 1), (0, -1), (5, 0)], [0.5, 0.5, 0.0]),
        ([], []),
    ],
)
def test_contacts_share_the_weight_so_that_nothing_tips(places: list[tuple[float, float]], shares: list[float]) -> None:
    assert shares_of([(x, y, 0.0) for x, y in places]) == pytest.approx(shares, abs=1e-6)


@pytest.mark.parametrize("engine", [None, *EACH_ENGINE])
@pytest.mark.parametrize("friction", [mu(0), mu(0.005), "<mu1>0.9</mu1><mu2>0.0</mu2>", '<mu1 value="0.001"/>'])
def test_wheels_without_friction_slip(tmp_path: Path, engine: str | None, friction: str) -> None:
    assert codes(run(tmp_path, surface(friction, "left", "right"), engine)) == ["UC976"]


@pytest.mark.parametrize("engine", [None, *EACH_ENGINE])
@pytest.mark.parametrize(
    "friction", [mu(0.3), mu(100000), "<mu1>1</mu1><mu2>0</mu2><fdir1>1 0 0</fdir1>", "<kp>1e6</kp>"]
)
def test_wheels_with_friction_drive(tmp_path: Path, engine: str | None, friction: str) -> None:
    assert codes(run(tmp_path, surface(friction, "left", "right"), engine)) == []


@pytest.mark.parametrize("engine", [None, *EACH_ENGINE])
def test_the_surface_of_collision_geometry_counts(tmp_path: Path, engine: str | None) -> None:
    nested = "<collision><surface><friction><ode><mu>0</mu><mu2>0</mu2></ode></friction></surface></collision>"
    assert codes(run(tmp_path, surface(nested, "left", "right"), engine)) == ["UC976"]


@pytest.mark.parametrize("engine", [None, *EACH_ENGINE])
def test_casters_with_friction_hold_wheels_with_little(tmp_path: Path, engine: str | None) -> None:
    both = surface(mu(0.05), "left", "right").replace(
        "</robot>", "".join(f'<gazebo reference="{name}">{mu(1)}</gazebo>' for name in ("front", "rear")) + "</robot>"
    )
    assert codes(run(tmp_path, surface(mu(0.2), "left", "right"), engine)) == []
    assert "UC976" in codes(run(tmp_path, both, engine))


def on_wheels_alone(grip: float, caster: float) -> str:
    """Return the rover without its front ball: it rests on its wheels, and 0.1 kg on a ball 15 cm behind them."""
    whole_robot = surface(mu(grip), "left", "right")
    begin, end = whole_robot.index('<link name="front">'), whole_robot.index('<link name="rear">')
    return (whole_robot[:begin] + whole_robot[end:]).replace(
        "</robot>", f'<gazebo reference="rear">{mu(caster)}</gazebo></robot>'
    )


@pytest.mark.parametrize("engine", EACH_ENGINE)
@pytest.mark.parametrize("grip", [0.004, 0.008])
def test_a_base_that_slips_is_accelerated_by_its_grip(tmp_path: Path, engine: str, grip: float) -> None:
    made = run(tmp_path, on_wheels_alone(grip, 0.0), engine)
    ahead = next(curve for curve in made.curves if curve.quantity == "ahead")
    seconds, wheels, everything = ahead.seconds[-1], 6.0 * 9.81, 6.1
    assert ahead.measured[-1] == pytest.approx(0.5 * wheels * grip / everything * seconds**2, rel=0.1)
    assert codes(made) == ["UC976"]
