"""Read ROS 2 launch files in XML and YAML into the terms of an equivalent file in Python."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from urdfctl.source.launch.terms import Called, Constant, Items, Table, Term, UnknownTerm
from urdfctl.source.span import Place
from urdfctl.source.xml.dom import Element
from urdfctl.source.yaml.tree import Mapping as YamlMap
from urdfctl.source.yaml.tree import Node as YamlNode
from urdfctl.source.yaml.tree import Scalar, YamlFile
from urdfctl.source.yaml.tree import Sequence as YamlList
from urdfctl.startup.records import NamedTuple

_MOST_DEPTH = 30
_ESCAPED = r"\\(['\"])"
"""A quote inside a quoted argument (launch, frontend/parse_substitution.py replace_escaped_characters())."""
_QUOTED = r"(?s)^(['\"])(.*)\1$"
_SUBSTITUTIONS: dict[str, tuple[str, int]] = {
    "var": ("LaunchConfiguration", 2),
    "env": ("EnvironmentVariable", 2),
    "find-pkg-share": ("FindPackageShare", 1),
    "find-exec": ("FindExecutable", 1),
    "dirname": ("ThisLaunchFileDir", 0),
    "filename": ("ThisLaunchFile", 0),
    "file-content": ("FileContent", 1),
    "not": ("NotSubstitution", 1),
    "and": ("AndSubstitution", 2),
    "or": ("OrSubstitution", 2),
    "any": ("AnySubstitution", 9),
    "all": ("AllSubstitution", 9),
    "equals": ("EqualsSubstitution", 2),
    "not-equals": ("NotEqualsSubstitution", 2),
}
"""The substitutions of XML and YAML: the class in Python, and the maximum number of arguments."""
_OF_NODES = {"package": "pkg", "executable": "exec", "name": "name", "namespace": "namespace", "shell": "shell"}
_OF_COMPONENTS = {"package": "pkg", "plugin": "plugin", "name": "name", "namespace": "namespace"}
_WHOLE = {"eval": "PythonExpression", "command": "Command"}
_PLAIN = {"log", "set_env", "unset_env", "append_env", "reset_env", "shutdown"} | {
    "set_ros_log_dir", "let_env", "cmd", "reset",
}  # fmt: skip
_FOR_ALL = {
    "set_parameter": "SetParameter",
    "set_parameters_from_file": "SetParametersFromFile",
    "set_remap": "SetRemap",
    "set_use_sim_time": "SetUseSimTime",
}


class Entity(NamedTuple):
    """An element of XML or a map of YAML.

    tag: name of the element or key of the map.
    attributes: texts by name.
    children: the elements or maps in it.
    """

    tag: str
    at: Place
    attributes: Mapping[str, Constant]
    children: tuple[Entity, ...]

    def named(self, *tags: str) -> Iterator[Entity]:
        """Return the children with one of these tags."""
        return (child for child in self.children if child.tag in tags)


def of_yaml(file: YamlFile) -> Entity | None:
    """Return the root of a launch file in YAML; None if it is not a launch file."""
    root = file.documents[0] if file.documents else None
    launch = root.get("launch") if isinstance(root, YamlMap) else None
    return Entity("launch", launch.at, {}, tuple(_of_list(launch, 0))) if isinstance(launch, YamlList) else None


def description(root: Entity) -> Term:
    """Return the launch description that a file in XML or YAML means."""
    return Called("LaunchDescription", root.at, [_actions(root)])


def of_xml(element: Element, depth: int = 0) -> Entity:
    """Return an element of a launch file in XML. What is nested too deeply is left out."""
    attributes = {name: Constant(value, element.at[name]) for name, value in element.attrs.items()}
    children = () if depth > _MOST_DEPTH else tuple(of_xml(child, depth + 1) for child in element.elements())
    return Entity(element.tagName, element.at, attributes, children)


def _of_list(items: YamlList, depth: int) -> Iterator[Entity]:
    for item in items.items:
        for entry in item.entries if isinstance(item, YamlMap) else ():
            yield _of_entry(entry.key.text, entry.key.at, entry.value, depth)


def _of_entry(tag: str, at: Place, value: YamlNode, depth: int) -> Entity:
    if depth > _MOST_DEPTH or isinstance(value, Scalar):
        return Entity(tag, at, {}, ())
    if isinstance(value, YamlList):
        return Entity(tag, at, {}, tuple(_of_list(value, depth + 1)))
    attributes: dict[str, Constant] = {}
    children: list[Entity] = []
    for entry in value.entries:
        if isinstance(entry.value, Scalar):
            attributes[entry.key.text] = Constant(entry.value.text, entry.value.at)
        elif isinstance(entry.value, YamlList) and entry.key.text == "children":
            children += _of_list(entry.value, depth + 1)
        elif isinstance(entry.value, YamlList):
            children += (_of_entry(entry.key.text, entry.key.at, item, depth + 1) for item in entry.value.items)
    return Entity(tag, at, attributes, tuple(children))


# -- actions ---------------------------------------------------------------------------------------------------------


def _actions(parent: Entity) -> Term:
    actions: list[Term] = []
    for child in parent.children:
        tag = child.tag.replace("-", "_")
        term: Term
        if tag in _ACTIONS:
            term = _ACTIONS[tag](child)
        elif tag in _PLAIN:
            term = Called("LogInfo", child.at)
        elif tag in _FOR_ALL:
            term = Called(_FOR_ALL[tag], child.at)
        else:
            term = UnknownTerm(child.at)
        if isinstance(term, Called):
            for attribute, condition in (("if", "IfCondition"), ("unless", "UnlessCondition")):
                if attribute in child.attributes:
                    term.keywords["condition"] = Called(condition, child.at, [_text(child, attribute)])
        actions.append(term)
    return Items(actions, parent.at)


def _text(entity: Entity, *names: str) -> Term:
    """The text of the first of these attributes that the entity has; unknown if it has none."""
    attribute = next((entity.attributes[name] for name in names if name in entity.attributes), None)
    return substituted(attribute) if attribute is not None else UnknownTerm(entity.at)


def _called(name: str, entity: Entity, attributes: Mapping[str, str]) -> Called:
    """A call with the keywords whose attributes the entity has.

    attributes: keywords in Python with the attribute's name.
    """
    keywords = {keyword: _text(entity, name) for keyword, name in attributes.items() if name in entity.attributes}
    return Called(name, entity.at, (), keywords)


def _node(entity: Entity) -> Called:
    term = _with_parameters(_called("Node", entity, _OF_NODES), entity)
    if "args" in entity.attributes:
        term.keywords["arguments"] = words_of(entity.attributes["args"])
    return term


def _container(entity: Entity) -> Called:
    components: list[Term] = [
        _with_parameters(_called("ComposableNode", child, _OF_COMPONENTS), child)
        for child in entity.named("composable_node", "composable-node")
    ]
    given = {"composable_node_descriptions": Items(components, entity.at)}
    return Called("ComposableNodeContainer", entity.at, (), given)


def _with_parameters(term: Called, entity: Entity) -> Called:
    parameters = [_parameter(child) for child in entity.named("param")]
    if parameters:
        term.keywords["parameters"] = Items(parameters, entity.at)
    remaps: list[Term] = [
        Items([_text(child, "from"), _text(child, "to")], child.at) for child in entity.named("remap")
    ]
    if remaps:
        term.keywords["remappings"] = Items(remaps, entity.at)
    return term


def _parameter(entity: Entity) -> Term:
    if "from" in entity.attributes:
        given = {name: _text(entity, name) for name in ("allow_substs",) if name in entity.attributes}
        return Called("ParameterFile", entity.attributes["from"].at, [_text(entity, "from")], given)
    table = Table(entity.at)
    value = _text(entity, "value")
    if "type" in entity.attributes:
        value = Called("ParameterValue", value.at, [value], {"value_type": _text(entity, "type")})
    elif isinstance(value, Constant):
        value = Called("TextSubstitution", value.at, [value])  # launch reads it as YAML, and a string in Python not
    table.put(entity.attributes.get("name") or UnknownTerm(entity.at), value)
    return table


def _executable(entity: Entity) -> Called:
    term = _called("ExecuteProcess", entity, {"shell": "shell"})
    if "cmd" in entity.attributes:
        term.keywords["cmd"] = words_of(entity.attributes["cmd"])
    return term


def _include(entity: Entity) -> Called:
    given = [Items([_text(child, "name"), _text(child, "value")], child.at) for child in entity.named("arg", "let")]
    return Called(
        "IncludeLaunchDescription", entity.at, [_text(entity, "file")], {"launch_arguments": Items(given, entity.at)}
    )


def _group(entity: Entity) -> Called:
    term = _called("GroupAction", entity, {"scoped": "scoped"})
    term.keywords["actions"] = _actions(entity)
    return term


def _timer(entity: Entity) -> Called:
    return Called("TimerAction", entity.at, (), {"actions": _actions(entity)})


_ACTIONS: dict[str, Callable[[Entity], Called]] = {
    "arg": lambda entity: _called("DeclareLaunchArgument", entity, {"name": "name", "default_value": "default"}),
    "let": lambda entity: _called("SetLaunchConfiguration", entity, {"name": "name", "value": "value"}),
    "node": _node,
    "node_container": _container,
    "load_composable_node": _container,
    "executable": _executable,
    "include": _include,
    "group": _group,
    "timer": _timer,
    "ros_timer": _timer,
    "push_ros_namespace": lambda entity: _called("PushRosNamespace", entity, {"namespace": "namespace"}),
}


# -- texts -----------------------------------------------------------------------------------------------------------


def words_of(text: Constant) -> Term:
    """Return the words of an attribute that is a command line, each with its place. Quoted blanks do not end a word."""
    whole = text.text or ""
    words: list[str] = []
    start = depth = 0
    quote = ""
    for index, char in enumerate(f"{whole} "):
        depth += (char == "(" and whole[index - 1 : index] == "$") - (char == ")" and depth > 0)
        if not depth and char in "'\"" and quote in {"", char}:
            quote = "" if quote else char
        if index == len(whole) or (char.isspace() and not depth and not quote):
            if index > start:
                words.append(whole[start:index])
            start = index + 1
    places = text.at.words(words)
    terms = [
        substituted(Constant(re.sub(_QUOTED, r"\2", word), place)) for word, place in zip(words, places, strict=True)
    ]
    return Items(terms, text.at)


def substituted(text: Constant, depth: int = 0) -> Term:
    """Return a text with each `$(...)` as the term of a substitution."""
    whole = text.text or ""
    if "$(" not in whole:
        return text
    parts: list[Term] = []
    index = 0
    while (start := whole.find("$(", index)) >= 0:
        end = _closing(whole, start)
        if end is None or depth > _MOST_DEPTH:
            return UnknownTerm(text.at)
        if start > index:
            parts.append(Constant(whole[index:start], text.at))
        parts.append(_substitution(whole[start + 2 : end], text.at, depth))
        index = end + 1
    if index < len(whole):
        parts.append(Constant(whole[index:], text.at))
    return parts[0] if len(parts) == 1 else Items(parts, text.at)


def _closing(text: str, start: int) -> int | None:
    depth = 0
    for index in range(start + 1, len(text)):
        depth += (text[index] == "(") - (text[index] == ")")
        if depth == 0:
            return index
    return None


def _substitution(inside: str, at: Place, depth: int) -> Term:
    name, _, rest = inside.strip().partition(" ")
    if name in _WHOLE:
        given = rest.strip()
        if name == "command":  # after the quotes: what to do with output on stderr
            given = re.sub(r"(['\"])\s+(['\"]?)(?:warn|fail|ignore|capture)\2$", r"\1", given)
        quoted = re.fullmatch(r"'(.*)'|\"(.*)\"", given, re.DOTALL)
        text = (quoted.group(1) if quoted.group(1) is not None else quoted.group(2)) if quoted else given
        return Called(_WHOLE[name], at, [substituted(Constant(re.sub(_ESCAPED, r"\1", text), at), depth + 1)])
    if name not in _SUBSTITUTIONS:
        return UnknownTerm(at)
    full, most = _SUBSTITUTIONS[name]
    arguments = [substituted(Constant(word, at), depth + 1) for word in _arguments(rest)]
    if full == "EnvironmentVariable" and len(arguments) > 1:
        return Called(full, at, arguments[:1], {"default_value": arguments[1]})
    return Called(full, at, arguments[:most])


def _arguments(text: str) -> Iterator[str]:
    """The arguments of a substitution: words, quoted or not, which can contain further substitutions."""
    start, depth, quote = 0, 0, ""
    for index, char in enumerate(f"{text} "):
        if quote:
            quote = "" if char == quote else quote
        elif char in "'\"" and not depth:
            quote = char
        else:
            depth += (char == "(") - (char == ")")
        if char.isspace() and not quote and not depth:
            if index > start:
                yield re.sub(r"^(['\"])(.*)\1$", r"\2", text[start:index])
            start = index + 1
