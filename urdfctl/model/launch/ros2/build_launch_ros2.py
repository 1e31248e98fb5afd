"""Build the model of a ROS 2 launch file from its terms, together with the files that it includes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from urdfctl.model.launch import Launch, Simulation, Word, joined
from urdfctl.model.launch.ros2.actions import (
    ALTERING,
    HANDLERS,
    HARMLESS,
    LATER,
    NODES,
    PROCESSES,
    SPAWNING,
    WITHOUT_CONTROLLERS,
    State,
)
from urdfctl.model.launch.ros2.arguments import Arguments
from urdfctl.model.launch.ros2.containers import nodes_in_container
from urdfctl.model.launch.ros2.descriptions import content_of
from urdfctl.model.launch.ros2.facts import LaunchFacts
from urdfctl.model.launch.ros2.moveit import LAUNCHES
from urdfctl.model.launch.ros2.nodes import Nodes
from urdfctl.model.launch.ros2.published import publisher_of
from urdfctl.model.launch.ros2.simulators import (
    COMPONENTS,
    commanded_simulation,
    included_nodes,
    included_simulation,
    node_of_component,
    node_simulation,
    package_outside,
    simulator_of,
    supervisor_of,
)
from urdfctl.model.launch.ros2.sources import Ros2Sources
from urdfctl.model.launch.ros2.texts import ActionScope, Texts, table_of
from urdfctl.model.launch.ros2.undeclared import OF_SIMULATORS, Undeclared
from urdfctl.model.launch.ros2.waiting import Handlers
from urdfctl.source.launch.terms import (
    Called,
    Constant,
    Function,
    Items,
    OneOf,
    Perhaps,
    Term,
    UnknownTerm,
)
from urdfctl.source.opaque import UNKNOWN, if_known
from urdfctl.source.span import Place

_MOST_DEPTH = 16
_MOST_INCLUDES = 200
_MOST_ACTIONS = 5000


def launch_of_ros2(path: str, arguments: Mapping[str, str], sources: Ros2Sources) -> Launch | None:
    """Return the model of a ROS 2 launch file that is started with these arguments; None if it is not such a file."""
    term = sources.read(path)
    if term is None:
        return None
    walk = _Walk(path, sources)
    scope = ActionScope(path, arguments)
    walk.action(term, scope, State())
    undeclared = tuple(dict.fromkeys(walk.undeclared.words))
    facts = walk.facts
    waiting = walk.handlers.waiting(walk.nodes(scope), complete=walk.complete)
    never = walk.handlers.never
    launch = Launch(
        path,
        2,
        tuple(facts.descriptions),
        tuple(facts.loads),
        facts.spawns_in_turn(),
        complete=walk.complete and not walk.unread,
        elsewhere=tuple(facts.elsewhere),
        nodes=tuple(node for node in facts.nodes if not any(node is other for other in never)),
        simulations=tuple(walk.simulations),
        references=tuple(facts.references.values()),
        undeclared=undeclared,
        arguments=tuple(walk.arguments.own.items()),
        choices=tuple(walk.arguments.choices.items()),
        slips=tuple(dict.fromkeys(walk.arguments.slips)),
        moveit=tuple(facts.moveit),
        given=tuple(facts.given),
        unread=tuple(walk.unread) if walk.complete else (),
        absent=tuple(walk.unread),
        skipped=tuple(dict.fromkeys(walk.skipped)),
        waiting=waiting,
    )
    missing = {one.file.path for one in launch.references if one.file.exists is False and one.file.path}
    made = {path for path in missing if any(path in word for word in walk.words_of_programs)}
    return launch.with_open_files(made) if made else launch


class _Walk:
    def __init__(self, path: str, sources: Ros2Sources) -> None:
        self.path, self.sources = path, sources
        self.facts = LaunchFacts(sources.locate)
        self.simulations: list[Simulation] = []
        self.words_of_programs: list[str] = []
        """The words of processes, which may write the files that they name."""
        self.arguments = Arguments()
        self.complete = True
        self.skipped: list[str] = []
        self.handlers = Handlers()
        self.unread: list[Word] = []
        """The included files that cannot be read."""
        self.undeclared = Undeclared()
        self._includes = self._actions = 0

    def texts(self, scope: ActionScope) -> Texts:
        return Texts(scope, self.sources, unset=self._unset)

    def _unset(self, name: str, at: Place) -> None:
        if self.complete:
            self.undeclared.use(name, at)

    def nodes(self, scope: ActionScope) -> Nodes:
        return Nodes(self.facts, self.texts(scope))

    # -- actions -----------------------------------------------------------------------------------------------------

    def action(self, term: Term | None, scope: ActionScope, state: State) -> None:
        """Follow an action or a list of actions."""
        self._actions += 1
        if self._actions > _MOST_ACTIONS or state.depth > _MOST_DEPTH * 4:
            self.complete = False
        elif isinstance(term, Items):
            for value in term.values:
                self.action(value, scope, state._replace(depth=state.depth + 1))
        elif isinstance(term, Perhaps):
            self._apart((term.term,), scope, state)
        elif isinstance(term, OneOf):
            self._apart(term.options, scope, state)
        elif isinstance(term, Called):
            self._called(term, scope, state)
        elif supervisor := supervisor_of(term):
            self._called(supervisor, scope, state)
        elif not (term is None or isinstance(term, Constant)):
            self.complete = False

    def _apart(self, terms: Sequence[Term], scope: ActionScope, state: State) -> None:
        """Follow actions each of which may run or not: what they set is known among themselves, and not after them."""
        scopes = [scope.copy() for _ in terms]
        for term, inner in zip(terms, scopes, strict=True):
            self.action(term, inner, state._replace(sure=False, depth=state.depth + 1))
        for inner in scopes:
            scope.blur(inner)

    def _called(self, term: Called, scope: ActionScope, state: State) -> None:
        used = len(self.undeclared)
        held = self.texts(scope).condition(term.keywords.get("condition"))
        if state.sure:  # so that the condition is evaluated in any case
            used = len(self.undeclared)
        if held is False:
            scope = scope.copy()
            state = state._replace(sure=False, held=False)
        if not state.held:
            self.skipped += [term.at.span.text, *self.nodes(scope).program(term)]
        outer = scope
        if held is None:
            scope, state = scope.copy(), state._replace(sure=False)
        self._act(term, scope, state._replace(depth=state.depth + 1))
        if held is None:
            outer.blur(scope)
        if not state.sure or term.short in LATER:
            self.undeclared.keep(used)
        self.handlers.may_start(term.keywords.get("on_exit"))

    def _act(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow an action whose condition may be true."""
        self.handlers.acts(term)
        if term.short in _ACTIONS:
            _ACTIONS[term.short](self, term, scope, state)
        elif term.short in NODES:
            before = len(self.facts.nodes)
            self.nodes(scope).node(term, sure=state.sure, held=state.held, after=state.after)
            for node in self.facts.nodes[before:]:
                self._simulates(node_simulation(node))
        elif term.short in PROCESSES:
            self._process(term, scope, state)
        elif term.short in SPAWNING:
            self.nodes(scope).helper(term, sure=state.sure, held=state.held)
        elif term.short in ALTERING:
            self.facts.altered = True
        elif term.short not in HARMLESS and state.held:
            self.complete = False

    def description(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow the actions of a launch description, including those added later."""
        self.action(term.given("initial_entities", 0), scope, state)
        for added in term.added:
            self.action(added, scope, state)

    def declared(self, term: Called, scope: ActionScope, _: State) -> None:
        """Declare a launch argument: set its default if no value was given.

        Only then launch performs the default (declare_launch_argument.py, execute()).
        """
        texts, used = self.texts(scope), len(self.undeclared)
        name = texts.of(term.given("name", 0))
        default = term.given("default_value", 1)
        if default is None and term.short == "DeclareBooleanLaunchArg":  # moveit_configs_utils, launch_utils.py
            default = Constant("False", term.at)
        choices = term.given("choices")
        allowed = [*map(texts.of, choices.values)] if isinstance(choices, Items) else None
        value = None if default is None else texts.of(default)
        self.arguments.declare(name, value, allowed, is_own=scope.file == self.path)
        if UNKNOWN in name or name in scope.settings:
            self.undeclared.keep(used)
            return
        if default is None and "default_value" in term.keywords:
            return
        scope.settings[name] = UNKNOWN if value is None else value or self.sources.blank()
        self._described(name, default, scope)

    def set(self, term: Called, scope: ActionScope, state: State) -> None:
        """Set a launch configuration (`let` in XML)."""
        texts = self.texts(scope)
        name = texts.of(term.given("name", 0))
        value = term.given("value", 1)
        if not state.held:
            return
        if UNKNOWN in name:
            self.complete = False
        else:
            scope.settings[name] = texts.of(value)
            self._described(name, value, scope)

    def _described(self, name: str, value: Term | None, scope: ActionScope) -> None:
        content = content_of(value, self.texts(scope), self.facts.exists) if value is not None else None
        if content is not None:
            scope.contents[name] = content

    def group(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow a group. Its settings end with it, unless it is not scoped."""
        texts = self.texts(scope)
        inner = scope if texts.truth(term.keywords.get("scoped")) is False else scope.copy()
        settings = table_of(term.keywords.get("launch_configurations"))
        if settings:
            inner.settings.update((name, texts.of(value)) for name, value in settings.entries.items())
        self.action(term.given("actions", 0), inner, state)

    def namespace(self, term: Called, scope: ActionScope, state: State) -> None:
        """Change the namespace of the following nodes (PushRosNamespace)."""
        if state.held:
            pushed = self.texts(scope).of(term.given("namespace", 0))
            scope.namespace = joined(scope.namespace, pushed)

    def opaque(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow an OpaqueFunction: call the function with the launch context, and follow the actions it returns."""
        function = term.given("function", 0)
        if not isinstance(function, Function):
            self.complete = False
            return
        given = term.given("args")
        arguments = given.values if isinstance(given, Items) else []
        keywords = table_of(term.given("kwargs"))
        context = UnknownTerm(term.at)
        used = len(self.undeclared)
        actions = function.call([context, *arguments], keywords.entries if keywords else {}, self.texts(scope).context)
        self.undeclared.keep(used)
        if b"launch_configurations" in term.at.source.data:
            self.undeclared.stop()
        self.action(actions, scope, state)

    def timer(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow the actions of a timer."""
        self.action(term.given("actions"), scope, state)

    def handler(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow the actions of an event handler for the start or the exit of a process."""
        event = term.given("event_handler", 0)
        if not isinstance(event, Called) or event.short not in HANDLERS:
            self.handlers.may_start(event)
            return
        target = event.given("target_action", 0)
        if isinstance(target, Called) and event.short != "OnProcessStart":
            arguments = self.nodes(scope).spawner_arguments(target)
            state = state._replace(after=tuple(word.text for word in arguments.names) if arguments else ())
        actions = event.given(HANDLERS[event.short], 1)
        if isinstance(actions, Function):
            actions = actions.call([UnknownTerm(term.at), UnknownTerm(term.at)], {}, self.texts(scope).context)
        facts, spawns, nodes = self.facts, len(self.facts.spawns), len(self.facts.nodes)
        self.action(actions, scope, state)
        if not isinstance(target, Called):
            self.handlers.may_start(target)
        elif state.sure:
            self.handlers.handles(event, target, facts.spawns[spawns:], facts.nodes[nodes:])

    def composed(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow the nodes that are loaded into a container, in one process, as nodes on their own."""
        self.action(nodes_in_container(term, self.texts(scope)), scope, state)

    def moveit(self, term: Called, scope: ActionScope, state: State) -> None:
        """Add what a function of moveit_configs_utils.launches starts, and what is added to its description."""
        self.nodes(scope).moveit(term, sure=state.sure, held=state.held)
        self.undeclared.stop()
        for added in term.added:
            self.action(added, scope, state)

    # -- included files ----------------------------------------------------------------------------------------------

    def include(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow an included launch file. Its settings stay in effect after it."""
        texts = self.texts(scope)
        source = term.given("launch_description_source", 0)
        if isinstance(source, Called) and source.short.endswith("LaunchDescriptionSource"):
            source = source.given("location", 0)
        if isinstance(source, Called) and source.short == "LaunchDescription":
            self.description(source, scope, state)
            return
        path = texts.of(source)
        given = table_of(term.given("launch_arguments"))
        is_simulator = simulator_of(path) is not None
        if not state.held:
            self.skipped.append(path)
        else:  # before the arguments are set: one may contain the former value of its own name
            self.nodes(scope).files_given(given, texts, sure=state.sure)
            if is_simulator:
                self._simulates(included_simulation(path, given, texts, term.at, sure=state.sure))
                space = if_known(scope.namespace)
                self.facts.nodes += included_nodes(path, given, texts, term.at, space, sure=state.sure)
        for name, value in given.entries.items() if given else ():
            scope.settings[name] = texts.of(value)
            self._described(name, value, scope)
        if not is_simulator and package_outside(path) not in WITHOUT_CONTROLLERS:
            declared, unread = len(self.arguments.declared), len(self.unread)
            self._follow(path, Word(path, (source or term).at), scope, state)
            if state.sure and self.complete and len(self.unread) == unread:
                self.arguments.give(given, self.arguments.declared[declared:])
        elif is_simulator:
            self.undeclared.simulate()
            if state.sure:
                self.arguments.give(given, OF_SIMULATORS)
        else:
            self.action(publisher_of(path, given, term.at), scope, state)
            self.undeclared.stop()

    def _follow(self, path: str, written: Word, scope: ActionScope, state: State) -> None:
        self._includes += 1
        included = None
        if UNKNOWN not in path:
            self.facts.reference(path, written.at, "include", sure=state.sure)
            if self._includes <= _MOST_INCLUDES and state.depth < _MOST_DEPTH * 4:
                included = self.sources.read(path)
        if included is None:
            self.undeclared.stop()
            if state.held:
                self.unread.append(written)
            return
        outer, scope.file = scope.file, path
        self.action(included, scope, state)
        scope.file = outer

    # -- simulators --------------------------------------------------------------------------------------------------

    def _simulates(self, simulation: Simulation | None) -> None:
        if simulation is not None:
            self.simulations.append(simulation)

    def component(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow an action of ros_gz or Webots that starts a node."""
        self._act(node_of_component(term), scope, state)

    def waiting(self, term: Called, scope: ActionScope, state: State) -> None:
        """Follow the nodes that are started when a driver is connected to Webots."""
        self.action(term.given("nodes_to_start", 1), scope, state)

    def _process(self, term: Called, scope: ActionScope, state: State) -> None:
        words = self.nodes(scope).command(term, sure=state.sure, held=state.held, after=state.after)
        texts = [word.text for word in words]
        if not texts or not state.held:
            return
        self.words_of_programs += texts
        self._simulates(commanded_simulation(texts, term.at, sure=state.sure))
        if texts[:2] == ["ros2", "launch"]:
            self.complete = False


_ACTIONS: dict[str, Callable[[_Walk, Called, ActionScope, State], None]] = {
    "LaunchDescription": _Walk.description,
    "DeclareLaunchArgument": _Walk.declared,
    "DeclareBooleanLaunchArg": _Walk.declared,
    "SetLaunchConfiguration": _Walk.set,
    "GroupAction": _Walk.group,
    "PushRosNamespace": _Walk.namespace,
    "PushROSNamespace": _Walk.namespace,
    "OpaqueFunction": _Walk.opaque,
    "TimerAction": _Walk.timer,
    "RosTimer": _Walk.timer,
    "ROSTimer": _Walk.timer,
    "RegisterEventHandler": _Walk.handler,
    "IncludeLaunchDescription": _Walk.include,
    "ComposableNodeContainer": _Walk.composed,
    "LoadComposableNodes": _Walk.composed,
    "WaitForControllerConnection": _Walk.waiting,
    **dict.fromkeys(COMPONENTS, _Walk.component),
    **dict.fromkeys(LAUNCHES, _Walk.moveit),
}
