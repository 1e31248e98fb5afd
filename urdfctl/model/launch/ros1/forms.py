"""What roslaunch refuses or ignores in the form of an element: its name, and its attributes.

The attributes are those of roslaunch's xmlloader.py; wiki.ros.org/roslaunch/XML lists them by element.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch.scope import Malformed
from urdfctl.model.launch.slips import slips
from urdfctl.names import nearest
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


class _Form(NamedTuple):
    required: tuple[str, ...] = ()
    optional: tuple[str, ...] = ()


_OF_PROGRAMS = (
    *("args", "clear_params", "cwd", "launch-prefix", "machine", "ns", "output", "required", "respawn"),
    *("respawn_delay", "launch-suffix"),
)
_CONTENTS = ("value", "textfile", "binfile", "command")
_FORMS = {
    "arg": _Form(("name",), ("default", "value", "doc")),
    "env": _Form(("name", "value")),
    "group": _Form((), ("ns", "clear_params")),
    "include": _Form(("file",), ("ns", "clear_params", "pass_all_args")),
    "node": _Form(("pkg", "type", "name"), _OF_PROGRAMS),
    "param": _Form(("name",), ("type", *_CONTENTS)),
    "remap": _Form(("from", "to")),
    "rosparam": _Form((), ("command", "file", "ns", "param", "subst_value")),
}
_OTHERS = ("machine", "master", "test")
_EVERYWHERE = ("if", "unless")
_NEVER_EMPTY = {"node": ("pkg", "type", "name"), "param": ("name",), "include": ("file",)}


def _is_of_others(name: str) -> bool:
    """Whether an attribute is for another program: with a namespace, or one that rosmon reads (rosmon_core
    src/launch/launch_config.cpp parseScopeAttributes())."""
    return ":" in name or name.startswith("rosmon-") or name == "enable-coredumps"


def malformed(element: Element) -> Iterator[Malformed]:
    """Yield what roslaunch does not take of an element that it reads."""
    form = _FORMS.get(element.tagName)
    if form is None:
        if element.tagName not in _OTHERS:
            yield _unknown(element)
        return
    allowed = (*form.required, *form.optional, *_EVERYWHERE)
    missing = [name for name in form.required if name not in element.attrs]
    others = (name for name in element.attrs if name not in allowed and not _is_of_others(name))
    unknown = slips(others, missing, form.optional)
    for name, meant in unknown.items():
        hint = f"; did you mean '{meant}'?" if meant else ""
        message = f"<{element.tagName}> has no attribute '{name}'{hint}"
        yield Malformed(element.at[name], message, refused=meant in missing)
    for name in missing:
        if name not in unknown.values():
            yield Malformed(element.at, f"<{element.tagName}> has no '{name}', which roslaunch requires")
    for name in _NEVER_EMPTY.get(element.tagName, ()):
        if not element.attrs.get(name, "x").strip():
            yield Malformed(element.at[name], f"'{name}' of <{element.tagName}> is empty")
    yield from _contents(element)


def _unknown(element: Element) -> Malformed:
    """An element that roslaunch does not know. It goes on without it, and without what is in it."""
    meant = nearest(element.tagName, _FORMS)
    hint = f"; did you mean <{meant}>?" if meant else ""
    return Malformed(element.at, f"roslaunch ignores <{element.tagName}>{hint}", refused=meant is not None)


def _contents(element: Element) -> Iterator[Malformed]:
    """A parameter or argument with two values, or none."""
    if element.tagName == "param":
        given = [name for name in _CONTENTS if name in element.attrs]
        if len(given) != 1:
            what = f"both '{given[0]}' and '{given[1]}'" if given else "none of value, textfile, binfile and command"
            yield Malformed(element.at, f"<param> has {what}; it needs exactly one")
    if element.tagName == "arg" and {"default", "value"} <= element.attrs.keys():
        yield Malformed(element.at, "<arg> has both 'default' and 'value'; it needs one of them")


def declared_twice(root: Element) -> Iterator[Malformed]:
    """Yield the declarations of arguments that a launch file already has, if no condition decides about either."""
    seen: set[str] = set()
    for element in root.elements():
        if element.tagName == "arg" and not any(name in element.attrs for name in _EVERYWHERE):
            name = element.attrs.get("name", "")
            if name in seen:
                yield Malformed(element.at, f"argument '{name}' is declared twice")
            seen.add(name)
