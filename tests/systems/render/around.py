"""Launch files around a start that is complete itself: with RViz beside it, or one that starts any file it is given."""

from __future__ import annotations

from systems.render.actions import Action, Arg, Include, LaunchFile, Node, Share
from systems.render.places import pick
from systems.render.plan import Plan, file_name


def add_around(plan: Plan) -> None:
    """Add the files that the switch says, around the only start."""
    form = plan.idioms["around"]
    if form == "nothing":
        return
    (start,) = plan.starts
    needed = tuple((name, default) for name, default in start.declared if default is None)
    included = Include(start.package, start.stem, tuple((name, (Arg(name),)) for name, _ in needed))
    if form == "handed on":
        launcher = _launcher(plan)
        parts = ("launch", file_name(plan, start))
        path = (Share((start.package,), tuple((part,) for part in parts)),)
        included = Include(launcher.package, launcher.stem, (("launch_file", path),))
        plan.files.append(launcher)
    actions: tuple[Action, ...] = (included, _rviz(plan)) if form == "rviz" else (included,)
    taken = {file.stem for file in plan.files}
    names = [name for name in ("demo", "everything", "complete", "start_all") if name not in taken]
    stem = pick(plan.system, "around", names)
    outer = LaunchFile(plan.places.bringup, stem, plan.language("top"), actions, needed)
    plan.files.insert(0, outer)
    plan.starts.insert(0, outer)


def _rviz(plan: Plan) -> Node:
    return Node("rviz", "rviz", "rviz") if plan.system.generation == 1 else Node("rviz2", "rviz2", "rviz2")


def _launcher(plan: Plan) -> LaunchFile:
    """A file that includes the one whose path it is given."""
    action = Include("", "", path=(Arg("launch_file"),))
    return LaunchFile(plan.places.bringup, "launcher", plan.language("top"), (action,), (("launch_file", None),))
