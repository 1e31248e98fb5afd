"""What the substitutions of ROS 2's launch files stand for, as far as nothing has to be run for it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping

from urdfctl.record import NamedTuple
from urdfctl.source.launch.python import evaluated
from urdfctl.source.launch.terms import Called, Constant, Context, Items, Table, Term, outside
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_TRUTH = {"true": True, "1": True, "false": False, "0": False}
_DEEPEST = 40
_MOST_CHARACTERS = 1 << 16


class Content(NamedTuple):
    """The text of a robot description: the file it is made of, the arguments for xacro (None where one is not known),
    their names with their places, and the command that makes it."""

    path: str | None
    arguments: tuple[tuple[str, str], ...] | None
    at: Place
    names: tuple[tuple[str, Place], ...] = ()
    command: str | None = None


class Scope:
    """What holds while a launch file is followed: its arguments by name, those of them that are a robot description,
    and the namespace that nodes come into (UNKNOWN where it is not known)."""

    __slots__ = ("contents", "file", "namespace", "settings")

    def __init__(self, file: str, settings: Mapping[str, str], namespace: str = "") -> None:
        self.file = file
        self.settings = dict(settings)
        self.contents: dict[str, Content] = {}
        self.namespace = namespace

    def copy(self) -> Scope:
        """The same, to be changed by itself."""
        copied = Scope(self.file, self.settings, self.namespace)
        copied.contents = dict(self.contents)
        return copied


class Texts:
    """Performs substitutions in a scope. `find` gives the folder of a package, None where it is not among the
    sources."""

    def __init__(self, scope: Scope, find: Callable[[str, Place], str | None], environ: Mapping[str, str]) -> None:
        self.scope = scope
        self.find = find
        self.environ = environ
        self._depth = 0

    @property
    def context(self) -> Context:
        """For functions that are called with the launch's context."""
        return Context(self.of)

    def of(self, term: Term | None) -> str:
        """The text that a term stands for, with UNKNOWN for what is not known of it."""
        if term is None or self._depth > _DEEPEST:
            return UNKNOWN
        self._depth += 1
        try:
            if isinstance(term, Constant):
                return "" if term.value is None else str(term.value)
            if isinstance(term, Items):
                return _joined(map(self.of, term.values))
            if isinstance(term, Called) and term.short in _PERFORMED:
                return _PERFORMED[term.short](self, term)
            return UNKNOWN
        finally:
            self._depth -= 1

    def truth(self, term: Term | None) -> bool | None:
        """Whether launch takes a text for true; None where that is not known."""
        return _TRUTH.get(self.of(term).strip().lower())

    def condition(self, term: Term | None) -> bool | None:
        """Whether a condition holds; None where that is not known. Without a condition it does."""
        if term is None:
            return True
        if not isinstance(term, Called):
            return None
        if term.short in {"IfCondition", "UnlessCondition"}:
            held = self.truth(term.given("predicate_expression", 0))
            return None if held is None else held is (term.short == "IfCondition")
        if term.short in {"LaunchConfigurationEquals", "LaunchConfigurationNotEquals"}:
            value = self.setting(self.of(term.given("launch_configuration_name", 0)), None)
            wanted = self.of(term.given("expected_value", 1))
            if UNKNOWN in value or UNKNOWN in wanted:
                return None
            return (value == wanted) is (term.short == "LaunchConfigurationEquals")
        return None

    def setting(self, name: str, default: Term | None) -> str:
        """The value of an argument of the launch file."""
        if name in self.scope.settings:
            return self.scope.settings[name]
        return self.of(default) if default is not None else UNKNOWN


def _joined(texts: Iterable[str]) -> str:
    made = "".join(texts)
    return made if len(made) <= _MOST_CHARACTERS else UNKNOWN


# -- what each substitution stands for -------------------------------------------------------------------------------


def _setting(texts: Texts, term: Called) -> str:
    return texts.setting(texts.of(term.given("variable_name", 0)), term.given("default", 1))


def _package(texts: Texts, term: Called) -> str:
    given = term.given("package", 0)
    name = texts.of(given)
    if given is None or UNKNOWN in name:
        return UNKNOWN
    return texts.find(name, given.at) or outside(name)


def _environment(texts: Texts, term: Called) -> str:
    name = texts.of(term.given("name", 0))
    if name in texts.environ:
        return texts.environ[name]
    default = term.given("default_value", 1)
    return UNKNOWN if default is None else texts.of(default)


def _path(texts: Texts, term: Called) -> str:
    parts = term.given("substitutions", 0)
    pieces = [texts.of(part) for part in parts.values] if isinstance(parts, Items) else [texts.of(parts)]
    return _joined([os.path.join("", *pieces)])


def _equals(texts: Texts, term: Called) -> str:
    left, right = texts.of(term.given("left", 0)), texts.of(term.given("right", 1))
    if UNKNOWN in left or UNKNOWN in right:
        return UNKNOWN
    same = left == right or (left.lower() in _TRUTH and _TRUTH.get(left.lower()) is _TRUTH.get(right.lower()))
    return str(same is (term.short == "EqualsSubstitution")).lower()


def _boolean(texts: Texts, term: Called) -> str:
    values = [texts.truth(given) for given in (*term.arguments, *term.keywords.values())]
    if term.short == "NotSubstitution":
        return UNKNOWN if values not in ([True], [False]) else str(not values[0]).lower()
    decisive = term.short in {"OrSubstitution", "AnySubstitution"}
    if decisive in values:
        return str(decisive).lower()
    return UNKNOWN if None in values or not values else str(not decisive).lower()


def _if_else(texts: Texts, term: Called) -> str:
    held = texts.truth(term.given("condition", 0))
    if held is None:
        return UNKNOWN
    return texts.of(term.given("if_value", 1) if held else term.given("else_value", 2) or Constant("", term.at))


def _only(keyword: str) -> Callable[[Texts, Called], str]:
    return lambda texts, term: texts.of(term.given(keyword, 0))


_PERFORMED: dict[str, Callable[[Texts, Called], str]] = {
    "LaunchConfiguration": _setting,
    "TextSubstitution": _only("text"),
    "ParameterValue": _only("value"),
    "ParameterFile": _only("param_file"),
    "PathSubstitution": _only("path"),
    "FindExecutable": _only("name"),
    "FindPackageShare": _package,
    "PathJoinSubstitution": _path,
    "ThisLaunchFileDir": lambda texts, _: os.path.dirname(texts.scope.file),
    "ThisLaunchFile": lambda texts, _: texts.scope.file,
    "EnvironmentVariable": _environment,
    "PythonExpression": lambda texts, term: evaluated(texts.of(term.given("expression", 0))),
    "EqualsSubstitution": _equals,
    "NotEqualsSubstitution": _equals,
    "NotSubstitution": _boolean,
    "AndSubstitution": _boolean,
    "OrSubstitution": _boolean,
    "AnySubstitution": _boolean,
    "AllSubstitution": _boolean,
    "IfElseSubstitution": _if_else,
}


def table_of(term: Term | None) -> Table | None:
    """The dict that a term is, or that the pairs of a list make: `{...}.items()`."""
    if isinstance(term, Table):
        return term
    if not isinstance(term, Items):
        return None
    table = Table(term.at)
    for pair in term.values:
        if isinstance(pair, Items) and len(pair.values) == 2:  # noqa: PLR2004 (a key and its value)
            table.put(pair.values[0], pair.values[1])
        else:
            table.whole = False
    return table
