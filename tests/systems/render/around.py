"""Launch files around a start that is complete itself: with RViz beside it, one that starts any file it is given, or
one that starts less of it."""

from __future__ import annotations

from systems.render.actions import Action, Arg, Include, LaunchFile, Node, Share, Value, When, parts_of
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
    _add_outer(plan, actions, needed)


def add_reduced(plan: Plan) -> None:
    """Add a file around the only start that starts less of it, by the argument of its condition, if the switch says so:
    a document starts it whole."""
    if plan.idioms["reduced"] == "nothing":
        return
    (start,) = plan.starts
    name = next(part.arg for part in parts_of(start.actions) if isinstance(part, When))
    (default,) = dict(start.declared)[name] or ()
    other = {"true": "false", "false": "true"}.get(str(default), "reduced")
    _add_outer(plan, (Include(start.package, start.stem, ((name, (other,)),)),), ())


def _add_outer(plan: Plan, actions: tuple[Action, ...], declared: tuple[tuple[str, Value | None], ...]) -> None:
    """Add a file around the only start."""
    taken = {file.stem for file in plan.files}
    names = [name for name in ("demo", "everything", "complete", "start_all") if name not in taken]
    outer = LaunchFile(plan.places.bringup, pick(plan.system, "around", names), plan.language("top"), actions, declared)
    plan.files.insert(0, outer)
    plan.starts.insert(0, outer)


def _rviz(plan: Plan) -> Node:
    return Node("rviz", "rviz", "rviz") if plan.system.generation == 1 else Node("rviz2", "rviz2", "rviz2")


def _launcher(plan: Plan) -> LaunchFile:
    """A file that includes the one whose path it is given."""
    action = Include("", "", path=(Arg("launch_file"),))
    return LaunchFile(plan.places.bringup, "launcher", plan.language("top"), (action,), (("launch_file", None),))
