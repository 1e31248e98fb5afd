"""What launch refuses in the form of an element in XML, or of a map in YAML.

It refuses a file whole, whatever its conditions are: each action reads its attributes and nested tags when the file is
parsed, and what is left then is an error (launch frontend/expose.py and entity.py, assert_entity_completely_parsed();
the names are those that the parse() methods of launch and launch_ros ask for, in any distro from humble on).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from urdfctl.model.launch.scope import Malformed
from urdfctl.model.launch.slips import slips
from urdfctl.names import is_slip, nearest
from urdfctl.source.launch.frontend import Entity
from urdfctl.startup.records import NamedTuple


class _EntityForm(NamedTuple):
    """The names of an entity's attributes and of what may be nested in it; `actions`: any action may."""

    required: tuple[str, ...] = ()
    optional: tuple[str, ...] = ()
    nested: tuple[str, ...] = ()
    actions: bool = False


_CONDITIONS = ("if", "unless")
_PAIR = _EntityForm(("name", "value"))
_REMAP = _EntityForm(("from", "to"))
_PARAM = _EntityForm((), ("name", "from", "value", "type", "allow_substs"), ("param",))
_OF_PROCESSES = (
    *("name", "cwd", "launch-prefix", "output", "respawn", "respawn_delay", "shell"),
    *("on_exit", "respawn_max_retries", "sigkill_timeout", "sigterm_timeout", "emulate_tty"),  # from jazzy on
)
_OF_NODES = ("pkg", *_OF_PROCESSES, "node-name", "namespace", "exec_name", "args", "ros_args", "autostart")
_NODE = _EntityForm(("exec",), _OF_NODES, ("param", "remap", "env"))
_ACTIONS = {
    "arg": _EntityForm(("name",), ("default", "description"), ("choice",)),
    "let": _PAIR,
    "executable": _EntityForm(("cmd",), _OF_PROCESSES, ("env",)),
    "node": _NODE,
    "lifecycle_node": _NODE,
    "node_container": _NODE._replace(nested=(*_NODE.nested, "composable_node")),
    "load_composable_node": _EntityForm(("target",), (), ("composable_node",)),
    "include": _EntityForm(("file",), (), ("arg", "let")),
    "group": _EntityForm((), ("scoped", "forwarding"), ("keep",), actions=True),
    "timer": _EntityForm(("period",), ("cancel_on_shutdown",), actions=True),
    "push_ros_namespace": _EntityForm(("namespace",)),
    "set_parameter": _EntityForm(("name", "value"), ("type",)),
    "set_remap": _REMAP,
    "set_env": _PAIR,
    "unset_env": _EntityForm(("name",)),
    "append_env": _EntityForm(("name", "value"), ("prepend", "separator")),
    "log": _EntityForm(("message",), ("level",)),
    "shutdown": _EntityForm((), ("reason",)),
}
_NESTED = {
    "arg": _PAIR,
    "let": _PAIR,
    "keep": _PAIR,
    "env": _PAIR,
    "choice": _EntityForm(("value",)),
    "remap": _REMAP,
    "param": _PARAM,
    "extra_arg": _PARAM,
    "composable_node": _EntityForm(
        ("pkg", "plugin"), ("name", "namespace", *_CONDITIONS), ("param", "remap", "extra_arg")
    ),
}
_NEVER_ACTIONS = {*_NESTED, "rosparam", "machine", "master", "test"} - {*_ACTIONS}
"""What stands in other elements only, and elements of ROS 1. Any other may be of a package that extends launch."""

_RENAMED = {
    "ns": "namespace",
    "type": "exec",
    "package": "pkg",
    "executable": "exec",
    "default_value": "default",
    "default": "value",
    "value": "default",
    "doc": "description",
}
"""Names in ROS 1, in Python or of another element, of what has another name here."""
_INSTEAD = {("group", "ns"): '; put <push_ros_namespace namespace="..."/> into it'}


def malformed(parent: Entity, nested: tuple[str, ...] = ()) -> Iterator[Malformed]:
    """Yield what launch refuses a file for.

    parent: the whole launch description, or an action that contains others.
    nested: what may stand in it beside actions.
    """
    for child in parent.children:
        tag = child.tag.replace("-", "_")
        if tag in nested:
            yield from _in(child, _NESTED[tag])
        elif tag in _ACTIONS:
            form = _ACTIONS[tag]
            yield from _in(child, form._replace(optional=(*form.optional, *_CONDITIONS)))
        else:
            meant = next((name for name in _ACTIONS if is_slip(tag, name)), None)
            if meant or tag in _NEVER_ACTIONS:
                yield Malformed(child.at, f"launch has no <{child.tag}> here, and refuses the file{_hint(meant)}")


def _in(entity: Entity, form: _EntityForm) -> Iterator[Malformed]:
    yield from _attributes(entity, form)
    if form.actions:
        yield from malformed(entity, form.nested)
        return
    for child in entity.children:
        tag = child.tag.replace("-", "_")
        if tag in form.nested:
            yield from _in(child, _NESTED[tag])
        elif child.tag not in (*form.required, *form.optional):  # a list, in YAML
            meant = nearest(child.tag, form.nested)
            yield Malformed(
                child.at, f"<{entity.tag}> takes no <{child.tag}>, and launch refuses the file{_hint(meant)}"
            )


def _attributes(entity: Entity, form: _EntityForm) -> Iterator[Malformed]:
    allowed = (*form.required, *form.optional)
    given = {*entity.attributes, *(child.tag for child in entity.children)}
    missing = [name for name in form.required if name not in given]
    # `value-sep`: what parts the values of a list
    others = (name for name in entity.attributes if ":" not in name and name.removesuffix("-sep") not in allowed)
    unknown = slips(others, missing, form.optional, alike=_meant)
    for name, meant in unknown.items():
        hint = f"; did you mean '{meant}'?" if meant else _INSTEAD.get((entity.tag, name), "")
        message = f"<{entity.tag}> has no attribute '{name}', and launch refuses the file{hint}"
        yield Malformed(entity.attributes[name].at, message)
    for name in missing:
        if name not in unknown.values():
            yield Malformed(entity.at, f"<{entity.tag}> has no '{name}', which launch requires")
    if form is _PARAM and not given & {"name", "from"}:
        yield Malformed(entity.at, f"<{entity.tag}> has neither 'name' nor 'from'; launch requires one of them")
    if {*_CONDITIONS} <= given:
        yield Malformed(entity.at, f"<{entity.tag}> has both 'if' and 'unless'; launch takes one of them")


def _meant(name: str, known: Collection[str]) -> str | None:
    """The attribute that is probably meant by a name: that of another language, or one with a slip."""
    if _RENAMED.get(name) in known:
        return _RENAMED[name]
    return next((other for other in known if is_slip(name, other)), None) or nearest(name, known)


def _hint(meant: str | None) -> str:
    return f"; did you mean <{meant}>?" if meant else ""
