"""What can be written in `${...}` and `$(arg ...)`: what is visible there, and can be what the attribute needs."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.server.analysis.items import OfferedItem
from urdfctl.server.analysis.scopes import MAP, NUMBER, TEXT, TRUTH, Defined, Scopes, is_number_at, is_positive_at
from urdfctl.server.analysis.spot import Spot
from urdfctl.server.analysis.xacro_names import ARGUMENT, PARAMETER, PROPERTY
from urdfctl.server.features.about_names import CONSTANTS
from urdfctl.server.features.fitting import defined_names, fitting_names, kind_at

_ARE_NAMES = frozenset({"name", "link", "reference", "joint", "params", "filename"})


def arguments(spot: Spot) -> Iterator[OfferedItem]:
    """Yield the arguments that can be written in `$(arg ...)`."""
    scopes = spot.scopes()
    expected = _expected(spot, scopes, "")
    for one in scopes.of(ARGUMENT):
        if _fits(scopes, one, expected):
            yield OfferedItem(one.name, ARGUMENT, f"default: `{one.value}`" if one.value is not None else "")


def values(spot: Spot) -> Iterator[OfferedItem]:
    """Yield the properties and parameters that can be written in `${...}`."""
    begun, opened = spot.before[spot.found.start() :], spot.opened
    if begun.count("'") % 2 or spot.found["dot"]:
        return
    scopes = spot.scopes()
    end = "[{}<>" + (opened["quote"] if opened else "") + "]"
    expected = _expected(spot, scopes, spot.found["before"] + re.split(end, spot.after)[0])
    if re.match(r"\w*\s*[\[.]", spot.after):
        expected = MAP
    must_be_positive = opened is not None and is_positive_at(opened["tag"], opened["name"])
    own = re.match(r"<xacro:property\s[^<>]*?name\s*=\s*[\"']([^\"']*)", spot.before)
    visible = [
        one
        for one in scopes.visible(spot.question.file, spot.start, spot.macro())
        if _fits(scopes, one, expected) and not (own and one.name == own[1])
        if not must_be_positive or scopes.is_positive(one)
    ]
    visible.sort(key=lambda one: expected is not None and scopes.nature(one) != expected)
    for one in _of_names(spot, visible, scopes) or visible:
        yield OfferedItem(one.name, one.kind, f"= `{one.value}`" if one.value is not None else "")
    if expected == NUMBER and not must_be_positive:
        yield OfferedItem("pi", PROPERTY, f"a constant of xacro: `{CONSTANTS['pi']}`")


def _expected(spot: Spot, scopes: Scopes, expression: str) -> str | None:
    """What the value at a place must be: a number, a truth value or a text; None if it is not known."""
    opened = spot.opened
    if opened is None:
        return None
    tag, attribute = opened["tag"], opened["name"]
    if is_number_at(tag, attribute) or ("'" not in expression and re.search(r"[*/-]", expression)):
        return NUMBER
    if tag in {"xacro:if", "xacro:unless"}:
        return TRUTH if not re.search(r"[=<>'\"]", expression) else TEXT if "'" in expression else None
    parameter = scopes.parameters(tag.removeprefix("xacro:")).get(attribute)
    if parameter is not None:
        return scopes.nature(parameter)
    return TEXT if attribute in _ARE_NAMES else None


def _fits(scopes: Scopes, one: Defined, expected: str | None) -> bool:
    nature = scopes.nature(one)
    if expected is None:
        return nature != MAP
    return nature == expected or (nature is None and (one.kind == PARAMETER or expected == MAP))


def _of_names(spot: Spot, visible: list[Defined], scopes: Scopes) -> list[Defined]:
    """Those with which the attribute names a link or joint that fits; none if it names none.

    A new link or joint is best one that the file refers to already.
    """
    opened = spot.opened
    if opened is None:
        return []
    tag, attribute, word = opened["tag"], opened["name"], spot.found["word"]
    before = opened["word"][: len(opened["word"]) - len(word)]
    tail = re.match(rf"\w*([^{opened['quote']}]*)", spot.after)
    after = tail[1] if tail else ""
    kind = kind_at(tag, attribute, spot.parent)
    written, expanded = set[str](), set[str]()
    if kind is not None:
        written = set(fitting_names(spot.question, kind))
        if (before, after) == ("${", "}"):
            expanded = {name.text for name in defined_names(spot.question, kind)}
    elif (tag, attribute) in {("link", "name"), ("joint", "name")}:
        data = spot.question.source.data
        written = {one.decode("utf-8", "replace") for one in re.findall(rb"\b%s=[\"']([^\"']*)" % tag.encode(), data)}
    return [one for one in visible if before + one.name + after in written or expanded & set(scopes.given(one))]
