"""The systems that make the sensors of models in SDF work in gz: once in each world that has such models."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.sensor_systems import AUTHORITY, SYSTEMS, is_loaded_in
from urdfctl.migrate.edits.markup import appended, content, elements, indent_of, parent_of, root_of, step_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.disk.gate import is_file
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_MODEL = "model://"
_LOADED_BY_NONE = "no model of this world can load it alone: load it here, with the default systems"
_OF_FILE = ("sdf", "gazebo")
"""What is around the model of a file: SDF 1.2 calls it gazebo."""
System = tuple[str, str]


class _Model(NamedTuple):
    """A model with sensors.

    name: of its folder, by which worlds include it; empty for one in a world.
    element: it, in one version of its file.
    needed: the systems of its sensors.
    """

    name: str
    element: Element
    needed: tuple[System, ...]

    def names(self, system: System) -> bool:
        """Return whether it loads a system already."""
        plugins = (one for one in elements(self.element) if one.tagName == "plugin")
        return any(is_loaded_in(one.attrs.get("filename", "").encode(), system) for one in plugins)


class _Plan:
    """Which models load which systems: some do already, the others are to."""

    def __init__(self) -> None:
        self.added: dict[int, tuple[_Model, list[System]]] = {}

    def loads(self, model: _Model, system: System) -> bool:
        """Return whether a model loads a system, or is to."""
        _, added = self.added.get(id(model.element), (model, ()))
        return system in added or model.names(system)

    def add(self, model: _Model, system: System) -> None:
        """Let a model load a system."""
        if not self.loads(model, system):
            self.added.setdefault(id(model.element), (model, []))[1].append(system)


def _systems_of_models(packages: MigratedPackages) -> Iterator[Proposal]:
    """One model of each world loads what the world does not: a system that two load would work twice."""
    if not goes_to_gz(packages) or packages.was_in_gz:
        return
    roots = [root for path in packages.files(*OF_SDF) if (root := root_of(packages.read(path))) is not None]
    models = [model for root in roots for model in _models(root) if packages.may_change(root.source.path)]
    every = [(one, _in_world(one, models)) for root in roots for one in root.elements() if one.tagName == "world"]
    worlds = sorted(every, key=lambda each: len({one.name for one in each[1]}))
    plan = _Plan()
    for world, inside in worlds:
        others = [each for other, each in worlds if other is not world]
        for system in dict.fromkeys(system for one in inside for system in one.needed):
            if not _planned(plan, world, inside, others, system):
                yield for_you(world.at, f"{system[0]}: {_LOADED_BY_NONE}", authority=AUTHORITY)
    included = {id(one.element) for _, inside in worlds for one in inside}
    _plan_spawned(plan, [one for one in models if id(one.element) not in included], roots)
    yield from (_loading(model, systems) for model, systems in plan.added.values())


def _planned(
    plan: _Plan, world: Element, inside: Sequence[_Model], others: Sequence[Sequence[_Model]], system: System
) -> bool:
    """Let one model of a world, in each of its versions, load a system; return False if none can.

    others: the models of the other worlds. One that has the system must not get it twice.
    """
    loading = [one for one in inside if plan.loads(one, system)]
    if not loading and is_loaded_in(world.source.data, system):
        return True
    has_it = [each for each in others if any(plan.loads(one, system) for one in each)]
    able = [one for one in inside if system in one.needed and not any(one in each for each in has_it)]
    chosen = [*loading, *able][:1]
    for one in inside:
        if chosen and _is_same(one, chosen[0]) and system in one.needed:
            plan.add(one, system)
    return bool(chosen)


def _plan_spawned(plan: _Plan, models: Sequence[_Model], roots: Sequence[Element]) -> None:
    """Let models that no world includes load their systems, unless a world may, or a file that is no model's own."""
    for model in models:
        others = [one.source for one in roots if one.source is not model.element.source and not _has_folder(one)]
        for system in model.needed:
            is_planned = any(plan.loads(one, system) for one in models if not one.name)
            if not is_planned and not any(is_loaded_in(other.data, system) for other in others):
                plan.add(model, system)


def _models(root: Element) -> Iterator[_Model]:
    """The models in a file that have sensors, without those inside of another one."""
    name = os.path.basename(os.path.dirname(root.source.path)) if _has_folder(root) else ""
    for element in elements(root) if b"<sensor" in root.source.data else ():
        around = parent_of(element)
        if element.tagName != "model" or element.close is None or around is None or around.tagName == "model":
            continue
        kinds = (one.attrs.get("type", "") for one in elements(element) if one.tagName == "sensor")
        needed = tuple(dict.fromkeys(SYSTEMS[kind] for kind in kinds if kind in SYSTEMS))
        if needed:
            yield _Model(name if around.tagName in _OF_FILE else "", element, needed)


def _in_world(world: Element, models: Sequence[_Model]) -> list[_Model]:
    """The models of a world: its own ones, and those that it includes, in each of their versions."""
    every = list(elements(world))
    addresses = (content(one) for one in every if one.tagName == "uri")
    names = {one.removeprefix(_MODEL).strip("/") for one in addresses if one.startswith(_MODEL)}
    own = {id(one) for one in every}
    return [one for one in models if id(one.element) in own or (one.name and one.name in names)]


def _is_same(one: _Model, other: _Model) -> bool:
    """Whether two are one model, or versions of one, of which the simulator reads only one."""
    return one.element is other.element or (one.name != "" and one.name == other.name)


def _has_folder(root: Element) -> bool:
    """Whether a file is in the folder of a model, where worlds find it by the folder's name."""
    return is_file(os.path.join(os.path.dirname(root.source.path), "model.config"))


def _loading(model: _Model, systems: Sequence[System]) -> Proposal:
    """The proposal to load systems in a model."""
    names = ", ".join(file for file, _ in systems)
    message = f"the model loads {names} for its sensors: no world of the packages does"
    option = "load them in the world"
    entry = ReportEntry(EntryKind.DECIDED, message, model.element.at, authority=AUTHORITY, option=option)
    indent = indent_of(model.element) + step_of(model.element.source)
    lines = (f'{indent}<plugin filename="{file}" name="{name}"/>' for file, name in systems)
    return Proposal((appended(model.element, lines),), entries=(entry,))


MODEL_SYSTEMS = Step(
    name="sensor-systems-of-models",
    part=Part.URDF,
    summary="Systems for the sensors of models in SDF",
    propose=_systems_of_models,
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "models/buoy/model.sdf": """
                <sdf version="1.6">
                  <model name="buoy">
                    <link name="hull">
                      <sensor name="motion" type="imu"/>
                    </link>
                  </model>
                </sdf>
            """,
        },
    ],
    after=[
        {
            "models/buoy/model.sdf": """
                <sdf version="1.6">
                  <model name="buoy">
                    <link name="hull">
                      <sensor name="motion" type="imu"/>
                    </link>
                    <plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>
                  </model>
                </sdf>
            """,
        },
    ],
)
