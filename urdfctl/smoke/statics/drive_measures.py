"""The measures of a mobile base against those that its controller assumes: radii, and distances between wheels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.rules.smoke.wheel_eccentric import wheel_eccentric
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import LEVEL, LinkBody, Mechanism, Wheel, is_wheel, wheels_of
from urdfctl.smoke.tasks import ControllerTask, Drive

MEASURES_DIFFER = 0.15
"""The accepted relative difference of a wheel's radius, or of the wheel separation, from the controller's parameter."""
MOST_ECCENTRIC = 0.1
"""The axis of a wheel may be off its middle by this fraction of its radius."""


def measure_troubles(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    """Yield the measures of a base that differ from those of its controller, and wheels that turn off their middle."""
    yield from _radii(mechanism, task, drive)
    yield from _apart(mechanism, task, drive)


def _radii(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    given = {name: drive.radius_of(name) for name in task.driven_joints}
    real = {
        name: mechanism.bodies[hinge.child].radius for name in given if (hinge := mechanism.hinge(name)) is not None
    }
    along = {wheel.hinge.name: mechanism.bodies[wheel.hinge.child].radius for wheel in _rolling_along(mechanism, drive)}
    eccentric = dict(_eccentric(mechanism, {**along, **real}))
    for name, body in eccentric.items():
        yield trouble_of(wheel_eccentric, f"link:{body.name}", task.controller, (), joint=name, off=body.off)
    real = {name: radius for name, radius in real.items() if name not in eccentric}
    for side, scale in (("left", drive.left_scale), ("right", drive.right_scale)):
        of_side = [real[name] or 0.0 for name in getattr(drive, side) if scale == 0 and name in real]
        if any(of_side):
            yield measure_differs(task, f"wheel radius times {side}_wheel_radius_multiplier", 0.0, of_side[0])
    wrong = [name for name, radius in real.items() if radius and differ(given[name], radius)]
    if wrong and len({round(real[name] or 0.0, 4) for name in wrong}) == 1 and len(wrong) == len(real):
        yield measure_differs(task, "wheel radius", given[wrong[0]], real[wrong[0]] or 0.0)
        return
    for name in wrong:
        yield measure_differs(task, f"radius of wheel '{name}'", given[name], real[name] or 0.0)


def _eccentric(mechanism: Mechanism, radii: Mapping[str, float | None]) -> Iterator[tuple[str, LinkBody]]:
    """The wheels that turn off their middle, with their links."""
    for name, radius in radii.items():
        hinge = mechanism.hinge(name)
        body = mechanism.bodies[hinge.child] if hinge else None
        if body and radius and body.off > MOST_ECCENTRIC * (radius - body.off):
            yield name, body


def _rolling_along(mechanism: Mechanism, drive: Drive) -> list[Wheel]:
    """The wheels on the ground that nothing drives."""
    wheels = wheels_of(mechanism, [hinge.name for hinge in mechanism.movable], drive.base)
    round_ones = [wheel for wheel in wheels if is_wheel(mechanism, wheel) and _is_round(wheel, mechanism)]
    bottoms = [wheel.place[2] - (mechanism.bodies[wheel.hinge.child].radius or 0.0) for wheel in round_ones]
    ground = min(bottoms, default=0.0)
    return [
        wheel
        for wheel, bottom in zip(round_ones, bottoms, strict=True)
        if bottom - ground <= 2 * (LEVEL + mechanism.bodies[wheel.hinge.child].off)
    ]


def _is_round(wheel: Wheel, mechanism: Mechanism) -> bool:
    """Whether a link turns roughly about its middle, as no link of an arm does."""
    body = mechanism.bodies[wheel.hinge.child]
    return body.off < ((body.radius or 0.0) - body.off) / 2


def _apart(mechanism: Mechanism, task: ControllerTask, drive: Drive) -> Iterator[Trouble]:
    """The distances between wheels. More than two driven wheels slip, so that theirs is not a measure."""
    left, right, driven = (wheels_of(mechanism, names, drive.base) for names in (drive.left, drive.right, drive.driven))
    if len(left) == 1 == len(right):
        apart = abs(left[0].place[1] - right[0].place[1])
        if differ(drive.separation, apart) or (drive.is_folded and apart > LEVEL):
            folded = "separation times wheel_separation_multiplier" if drive.is_folded else "separation"
            yield measure_differs(task, f"wheel {folded}", drive.separation, apart)
    if len(drive.roles) == len(driven) == 4:  # noqa: PLR2004
        spans = (max(w.place[n] for w in driven) - min(w.place[n] for w in driven) for n in range(2))
        reach = sum(spans) / 2
        if differ(drive.reach, reach):
            yield measure_differs(task, "half wheelbase plus half track", drive.reach, reach)
    yield from _steered_measures(mechanism, task, drive, driven)


def _steered_measures(
    mechanism: Mechanism, task: ControllerTask, drive: Drive, driven: Sequence[Wheel]
) -> Iterator[Trouble]:
    """The distances between axles, and between the wheels on an axle.

    A track is that of the wheels; that of their pivots is accepted as well, for which the formula is exact.
    """
    steered, turned_wheels = pivots_of(mechanism, drive), _turned_wheels(mechanism, drive)
    fixed = _fixed_axle(mechanism, drive, driven, turned_wheels)
    if fixed and steered:
        lengths = [abs(mean_of(fixed, 0) - mean_of(front, 0)) for front in (turned_wheels, steered) if front]
        if all(differ(drive.wheelbase, length) for length in lengths):
            yield measure_differs(task, "wheelbase", drive.wheelbase, lengths[0])
    of_driven = [driven, *([steered] if _is_same_axle(turned_wheels, driven) else [])]
    axles = (("traction", of_driven, drive.track), ("steering", [turned_wheels, steered], drive.steering_track))
    for name, axle, given in axles:
        tracks = [abs(two[0].place[1] - two[1].place[1]) for two in axle if len(two) == 2]  # noqa: PLR2004
        if tracks and all(differ(given, track) for track in tracks):
            yield measure_differs(task, f"{name} track width", given, tracks[0])


def _turned_wheels(mechanism: Mechanism, drive: Drive) -> list[Wheel]:
    """The wheels that hang on steering joints."""
    pivots = [hinge.child for name in drive.steered if (hinge := mechanism.hinge(name)) is not None]
    below = {link for pivot in pivots for link in mechanism.below(pivot)}
    names = [hinge.name for hinge in mechanism.hinges if hinge.parent in below]
    return [wheel for wheel in wheels_of(mechanism, names, drive.base) if is_wheel(mechanism, wheel)]


def _fixed_axle(
    mechanism: Mechanism, drive: Drive, driven: Sequence[Wheel], turned_wheels: Sequence[Wheel]
) -> Sequence[Wheel]:
    """The wheels that no joint steers: the driven ones, or those that roll along if the driven ones are steered."""
    if not _is_same_axle(turned_wheels, driven):
        return driven
    own = {wheel.hinge.name for wheel in (*turned_wheels, *driven)}
    names = [hinge.name for hinge in mechanism.hinges if hinge.name not in own]
    rolling = [wheel for wheel in wheels_of(mechanism, names, drive.base) if is_wheel(mechanism, wheel)]
    bottoms = [wheel.place[2] - (mechanism.bodies[wheel.hinge.child].radius or 0.0) for wheel in rolling]
    ground = min((w.place[2] - (mechanism.bodies[w.hinge.child].radius or 0.0) for w in driven), default=0.0)
    standing = [w for w, bottom in zip(rolling, bottoms, strict=True) if abs(bottom - ground) <= 2 * LEVEL]
    axles = {round(wheel.place[0], 2) for wheel in standing}
    return standing if len(axles) == 1 else []


def _is_same_axle(some: Sequence[Wheel], others: Sequence[Wheel]) -> bool:
    """Whether some wheels have one in common with others."""
    return bool({wheel.hinge.name for wheel in some} & {wheel.hinge.name for wheel in others})


def fixed_axle(mechanism: Mechanism, drive: Drive) -> Sequence[Wheel]:
    """Return the wheels that no joint steers, on one axle; none if there are none, or several axles."""
    driven = wheels_of(mechanism, drive.driven, drive.base)
    return _fixed_axle(mechanism, drive, driven, _turned_wheels(mechanism, drive))


def pivots_of(mechanism: Mechanism, drive: Drive) -> list[Wheel]:
    """Return the steering joints of a base."""
    return wheels_of(mechanism, drive.steered, drive.base)


def mean_of(wheels: Sequence[Wheel], way: int) -> float:
    """Return the mean place of some wheels along an axis, in m."""
    return sum(wheel.place[way] for wheel in wheels) / len(wheels)


def measure_differs(task: ControllerTask, measure: str, expected: float, actual: float) -> Trouble:
    """Return the finding that a measure, in m, is not the one that the controller expects."""
    subject, fields = f"controller:{task.controller}", {"measure": measure}
    shown = {"expected": f"{expected:g}", "actual": f"{actual:.3g}"}
    return trouble_of(wheel_measures_differ, subject, task.controller, (), **fields, **shown)


def differ(given: float, real: float) -> bool:
    """Return whether a measure is given and known, and differs by more than what calibration changes."""
    return given > 0 and real > 0 and abs(given / real - 1) > MEASURES_DIFFER
