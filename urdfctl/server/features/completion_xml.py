"""What can be written at a place of a URDF, xacro, SRDF or XML launch file."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.question import Question
from urdfctl.server.analysis.scopes import Defined, Scopes, written_default
from urdfctl.server.analysis.spot import ATTRIBUTE, OPEN_ATTRIBUTE, Spot, names_of_attributes
from urdfctl.server.analysis.xacro_names import MACRO, PARAMETER
from urdfctl.server.features.completion_expressions import arguments, values
from urdfctl.server.features.fitting import defined_names, fitting_interfaces, fitting_names, kind_at
from urdfctl.server.features.paths import files_in_package, packages_with
from urdfctl.server.features.spawning import OF_SPAWNER, in_spawner

_OPEN_CALL = rf"<xacro:(?P<macro>[\w.-]+)(?P<given>(?:{ATTRIBUTE})*)\s+(?P<word>\w*)$"
_INTERFACES = {"command_interface", "state_interface"}


def in_xml(question: Question) -> Iterator[OfferedItem]:
    """Yield what can be written at a place."""
    before = question.source.data[: question.offset].decode("utf-8", "replace")
    before = before[before.rfind("<") :] if "<" in before else ""
    for pattern, answer in _ANSWERS:
        found = re.search(pattern, before, re.DOTALL)
        if found:
            for item in answer(Spot(question, before, found)):
                is_part = answer is _in_attribute and item.kind in OF_SPAWNER
                yield item if is_part else item._replace(replaces=len(found["word"] or ""))
            return


def _packages(spot: Spot) -> Iterator[OfferedItem]:
    rest = re.match(r"[\w.-]*\)?/([^\"'$()<>\s]+)", spot.after)
    yield from (OfferedItem(name, "package") for name in packages_with(spot.question, rest[1] if rest else ""))


def _files(spot: Spot) -> Iterator[OfferedItem]:
    tag = spot.opened["tag"] if spot.opened else spot.tag
    yield from files_in_package(spot.question, tag, spot.found["package"], spot.found["word"])


# -- macros ------------------------------------------------------------------------------------------------------------


def _macros(spot: Spot) -> Iterator[OfferedItem]:
    """The macros that can be called with the attributes that are written already."""
    scopes, around = spot.scopes(), spot.macro()
    tail = re.match(rf"[\w.-]*(?P<given>(?:{ATTRIBUTE})*)\s*(?P<end>/?>)", spot.after)
    for one in scopes.of(MACRO):
        is_defined = bool(around) or one.file != spot.question.file or one.start < spot.start
        if one.name and one.name != around and is_defined and (tail is None or _is_called_so(scopes, one, tail)):
            words = ", ".join(f"`{name}`" for name in scopes.parameters(one.name))
            yield OfferedItem(f"xacro:{one.name}", MACRO, f"parameters: {words}" if words else "")


def _is_called_so(scopes: Scopes, macro: Defined, tail: re.Match[str]) -> bool:
    """Return whether a macro takes the attributes of a call. tail: the call after the macro's name."""
    parameters = scopes.parameters(macro.name)
    given = names_of_attributes(tail["given"])
    needed = {each.name for each in parameters.values() if each.value is None and not each.is_block}
    blocks = any(each.is_block and each.value is None for each in parameters.values())
    return needed <= given <= set(parameters) and not (blocks and tail["end"] == "/>")


def _macro_parameters(spot: Spot) -> Iterator[OfferedItem]:
    """The parameters that a call does not give yet, with their defaults; first those that it must give."""
    tail = re.match(rf"[\w-]*(?:\s*=\s*(?:\"[^\"]*\"|'[^']*'))?(?P<given>(?:{ATTRIBUTE})*)", spot.after)
    given = names_of_attributes(spot.found["given"] + (tail["given"] if tail else ""))
    parameters = spot.scopes().parameters(spot.found["macro"]).values()
    for one in sorted(parameters, key=lambda each: each.value is not None):
        if one.name not in given and not one.is_block:
            about = "must be given" if one.value is None else f"default: `{one.value}`"
            yield OfferedItem(f'{one.name}="{written_default(one.value or "")}"', PARAMETER, about)


# -- attributes --------------------------------------------------------------------------------------------------------


def _in_attribute(spot: Spot) -> Iterator[OfferedItem]:
    tag, attribute, question = spot.found["tag"], spot.found["name"], spot.question
    kind = kind_at(tag, attribute, spot.parent)
    if kind is not None:
        fitting = list(fitting_names(question, kind))
        is_unknown = not fitting and not question.is_current
        texts = (name.text for name in defined_names(question, kind)) if is_unknown else fitting
        yield from (OfferedItem(text, kind) for text in texts)
    elif tag in _INTERFACES and attribute == "name":
        yield from (OfferedItem(name, "interface") for name in fitting_interfaces(question))
    elif tag == "node" and attribute == "args":
        yield from in_spawner(question, spot.found["word"], is_spawner="spawn" in spot.before)


_ANSWERS: list[tuple[str, Callable[[Spot], Iterator[OfferedItem]]]] = [
    (r"\$\(find(?:-pkg-share)?\s+(?P<word>[\w.-]*)$", _packages),
    (r"(?:package|model)://(?P<word>[\w.-]*)$", _packages),
    (r"\$\(find(?:-pkg-share)?\s+(?P<package>[\w.-]+)\)/(?P<word>[^\"'$()<>\s]*)$", _files),
    (r"(?:package|model)://(?P<package>[\w.-]+)/(?P<word>[^\"'$()<>\s]*)$", _files),
    (r"\$\((?:arg|var)\s+(?P<word>[\w.-]*)$", arguments),
    (r"\$\{(?P<before>[^{}]*?)(?P<dot>\.?)(?P<word>(?:(?<![\w.])[A-Za-z_]\w*)?)$", values),
    (r"^<(?P<word>(?:xacro:)?[\w.-]*)$", _macros),
    (f"^{OPEN_ATTRIBUTE}", _in_attribute),
    (f"^{_OPEN_CALL}", _macro_parameters),
]
