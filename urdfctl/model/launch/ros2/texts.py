"""Perform the substitutions of ROS 2 launch files, as far as possible without running anything."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping

from urdfctl.model.launch import UNCHANGED, Rewriting
from urdfctl.model.launch.ros2.sources import Ros2Sources
from urdfctl.source.launch.python import evaluated
from urdfctl.source.launch.terms import Called, Constant, Context, Items, Table, Term, outside
from urdfctl.source.lengths import MOST_CHARACTERS, until_too_long
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.source.variables import required
from urdfctl.startup.records import NamedTuple

_TRUTH = {"true": True, "1": True, "false": False, "0": False}
_DEEPEST = 40
_MOST_PARTS = 10_000
"""Parts of one text, and of all that it is made of. A list that contains itself twice, and so on, has any number."""


class Content(NamedTuple):
    """A robot description.

    path: its URDF or xacro file; None if unknown.
    arguments: the arguments for xacro, whose values may be unknown; None if it is unknown which ones are given.
    names: the names of the arguments with their places.
    command: the command that prints it; None if there is none.
    alternatives: other arguments, where an unknown condition decides.
    as_yaml: whether launch parses the text as YAML: the output of a substitution without a type.
    more: whether other arguments may be given too, which are not known.
    edited: whether the launch file replaces parts of the text, such as comments.
    by_xacro: whether xacro expands the file, whatever its name is.
    """

    path: str | None
    arguments: tuple[tuple[str, str], ...] | None
    at: Place
    names: tuple[tuple[str, Place], ...] = ()
    command: str | None = None
    alternatives: tuple[tuple[tuple[str, str], ...], ...] = ()
    as_yaml: bool = False
    more: bool = False
    edited: bool = False
    by_xacro: bool = False


class ActionScope:
    """The state of a launch file while its actions are followed.

    file: path of the file.
    settings: the launch configurations by name.
    contents: those launch configurations that are a robot description.
    namespace: the namespace of nodes; UNKNOWN if unknown.
    """

    __slots__ = ("contents", "file", "namespace", "settings")

    def __init__(self, file: str, settings: Mapping[str, str], namespace: str = "") -> None:
        self.file = file
        self.settings = dict(settings)
        self.contents: dict[str, Content] = {}
        self.namespace = namespace

    def copy(self) -> ActionScope:
        """Return an independent copy."""
        copied = ActionScope(self.file, self.settings, self.namespace)
        copied.contents = dict(self.contents)
        return copied

    def blur(self, other: ActionScope) -> None:
        """Forget what is different in another scope, which may be in effect instead."""
        for name, value in other.settings.items():
            if self.settings.get(name) != value:
                self.settings[name] = UNKNOWN
        for name in [name for name, content in other.contents.items() if self.contents.get(name) != content]:
            self.contents.pop(name, None)
        if other.namespace != self.namespace:
            self.namespace = UNKNOWN


class Texts:
    """Performs substitutions in a scope.

    sources: files, packages and the environment.
    unset: is told the name of a launch configuration that is used, although nothing has set it, and its place.
    """

    def __init__(self, scope: ActionScope, sources: Ros2Sources, unset: Callable[[str, Place], None]) -> None:
        self.scope, self.sources, self.unset = scope, sources, unset
        self._depth = self._parts = 0

    @property
    def context(self) -> Context:
        """The launch context for functions that get one."""
        return Context(self.of)

    def of(self, term: Term | None) -> str:
        """Return the text of a term, with UNKNOWN for its unknown parts."""
        self._parts = self._parts + 1 if self._depth else 0
        if term is None or self._depth > _DEEPEST or self._parts > _MOST_PARTS:
            return UNKNOWN
        self._depth += 1
        try:
            if isinstance(term, Constant):
                return "" if term.value is None else str(term.value)
            if isinstance(term, Items):
                return self.joined(map(self.of, term.values), term.at)
            if isinstance(term, Called) and term.short in _PERFORMED:
                return _PERFORMED[term.short](self, term)
            return UNKNOWN
        finally:
            self._depth -= 1

    def joined(self, parts: Iterable[str], at: Place, join: Callable[..., str] = "".join) -> str:
        """Return the parts of a text that stands at a place as one; UNKNOWN if it is too long."""
        text = join([*until_too_long(parts)])
        if len(text) <= MOST_CHARACTERS:
            return text
        self.sources.too_long(at)
        return UNKNOWN

    def truth(self, term: Term | None) -> bool | None:
        """Return the boolean value of a text in a launch file; None if unknown."""
        return _TRUTH.get(self.of(term).strip().lower())

    def condition(self, term: Term | None) -> bool | None:
        """Return whether a condition is true; None if unknown. No condition counts as true."""
        if term is None or (isinstance(term, Constant) and term.value is None):
            return True
        if not isinstance(term, Called):
            return None
        if term.short in {"IfCondition", "UnlessCondition"}:
            predicate = term.given("predicate_expression", 0)
            held = None if _is_of_environment(predicate) else self.truth(predicate)
            return None if held is None else held is (term.short == "IfCondition")
        if term.short in {"LaunchConfigurationEquals", "LaunchConfigurationNotEquals"}:
            value = self.setting(self.of(term.given("launch_configuration_name", 0)), None)
            wanted = self.of(term.given("expected_value", 1))
            if UNKNOWN in value or UNKNOWN in wanted:
                return None
            return (value == wanted) is (term.short == "LaunchConfigurationEquals")
        return None

    def setting(self, name: str, default: Term | None) -> str:
        """Return the value of a launch configuration, otherwise its default; UNKNOWN if it has neither."""
        if name in self.scope.settings:
            return self.scope.settings[name]
        return self.of(default) if default is not None else UNKNOWN


def _is_of_environment(term: Term | None) -> bool:
    """Whether an environment variable decides about a condition: then neither branch is certain."""
    pending = [term]
    seen: set[int] = set()
    while pending:
        part = pending.pop()
        if id(part) in seen or not isinstance(part, Items | Called):
            continue
        seen.add(id(part))
        if isinstance(part, Called) and part.short == "EnvironmentVariable":
            return True
        pending += part.values if isinstance(part, Items) else part.arguments
    return False


# -- substitutions ---------------------------------------------------------------------------------------------------


def _setting(texts: Texts, term: Called) -> str:
    given, default = term.given("variable_name", 0), term.given("default", 1)
    name = texts.of(given)
    if given is not None and default is None and name not in texts.scope.settings:
        texts.unset(name, given.at)
    return texts.setting(name, default)


def _package(texts: Texts, term: Called) -> str:
    given = term.given("package", 0)
    name = texts.of(given)
    if given is None or UNKNOWN in name:
        return UNKNOWN
    return texts.sources.find(name, given.at) or outside(name)


def _environment(texts: Texts, term: Called) -> str:
    name = texts.of(term.given("name", 0))
    default = term.given("default_value", 1)
    is_default = default is not None and name not in texts.sources.environ
    return texts.of(default) if is_default else required(texts.sources.environ, name)


def _path(texts: Texts, term: Called) -> str:
    parts = term.given("substitutions", 0)
    pieces = map(texts.of, parts.values) if isinstance(parts, Items) else iter([texts.of(parts)])
    return texts.joined(pieces, term.at, lambda known: os.path.join("", *known))


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
    "ReplaceString": _only("source_file"),
    "RewrittenYaml": _only("source_file"),
    "FindExecutable": _only("name"),
    "FindPackageShare": _package,
    "PathJoinSubstitution": _path,
    "ThisLaunchFileDir": lambda texts, _: os.path.dirname(texts.scope.file),
    "ThisLaunchFile": lambda texts, _: texts.scope.file,
    "EnvironmentVariable": _environment,
    "PythonExpression": lambda texts, term: evaluated(
        texts.of(term.given("expression", 0)), too_long=lambda: texts.sources.too_long(term.at)
    ),
    "EqualsSubstitution": _equals,
    "NotEqualsSubstitution": _equals,
    "NotSubstitution": _boolean,
    "AndSubstitution": _boolean,
    "OrSubstitution": _boolean,
    "AnySubstitution": _boolean,
    "AllSubstitution": _boolean,
    "IfElseSubstitution": _if_else,
}


_REWRITING = {"ReplaceString": "replacements", "RewrittenYaml": "param_rewrites"}
"""The substitutions that rewrite a file, with the keyword that says what is rewritten."""


def rewriting_of(term: Term | None, texts: Texts) -> Rewriting:
    """Return how a launch file rewrites a parameter file (nav2_common, replace_string.py and rewritten_yaml.py)."""
    if not isinstance(term, Called):
        return UNCHANGED
    if term.short == "ParameterFile":
        inner = rewriting_of(term.given("param_file", 0), texts)
        if not texts.truth(term.given("allow_substs", 1) or Constant("false", term.at)):
            return inner
        settings = ((name, value) for name, value in texts.scope.settings.items() if UNKNOWN not in value)
        return inner._replace(texts=(*inner.texts, *((f"$(var {name})", value) for name, value in settings)))
    if term.short not in _REWRITING:
        return UNCHANGED
    inner = rewriting_of(term.given("source_file", 0), texts)
    table = table_of(term.given(_REWRITING[term.short], 1))
    pairs = tuple((old, texts.of(new)) for old, new in table.entries.items()) if table else ()
    if term.short == "ReplaceString":
        return inner._replace(texts=(*inner.texts, *pairs))
    root = term.given("root_key", 2)
    return inner._replace(values=(*inner.values, *pairs), root=texts.of(root) if root is not None else inner.root)


def table_of(term: Term | None) -> Table | None:
    """Return a term as a dict, if it is a dict or a list of pairs, such as `{...}.items()`; None otherwise."""
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
