"""Classes that launch files and the modules of their packages define: what their attributes and objects are."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence

from urdfctl.source.launch.frames import Frame
from urdfctl.source.launch.terms import (
    Called,
    Function,
    ImportedName,
    Items,
    OwnClass,
    OwnMethod,
    OwnObject,
    Table,
    Term,
    UnknownTerm,
    one_of,
)
from urdfctl.source.span import Place

_KINDS = frozenset({"staticmethod", "classmethod", "property"})
_PLAIN_BASES = frozenset({"object", "ABC", "abc.ABC", "Generic", "typing.Generic"})
_DATACLASS = "dataclass"


def class_of(
    node: ast.ClassDef,
    bases: Sequence[Term],
    inner: Frame,
    method: Callable[[ast.FunctionDef], Function],
    at: Place,
) -> Term:
    """Return the term of a class; unknown if it has a base or a decorator that is not understood.

    inner: the names that the statements of its body have assigned.
    method: returns the term of a function in its body.
    """
    members: dict[str, Term] = {}
    fields: list[str] = []
    for base in reversed(bases):
        if isinstance(base, OwnClass):
            members.update(base.members)
            fields += base.fields or ()
        elif not (isinstance(base, ImportedName) and base.path in _PLAIN_BASES):
            return UnknownTerm(at)
    decorators = [_name_of(decorator) for decorator in node.decorator_list]
    if not {*decorators} <= {_DATACLASS}:
        return UnknownTerm(at)
    members.update(inner.names)
    for one in node.body:
        if isinstance(one, ast.FunctionDef):
            kinds = [_name_of(decorator) for decorator in one.decorator_list]
            function = method(one)
            is_known = {*kinds} <= _KINDS and len(kinds) <= 1
            members[one.name] = OwnMethod(function, "".join(kinds), function.at) if is_known else UnknownTerm(at)
        elif isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name):
            fields.append(one.target.id)
    return OwnClass(node.name, members, tuple(dict.fromkeys(fields)) if decorators else None, at)


def _name_of(decorator: ast.expr) -> str:
    decorator = decorator.func if isinstance(decorator, ast.Call) else decorator
    if isinstance(decorator, ast.Attribute):
        return decorator.attr
    return decorator.id if isinstance(decorator, ast.Name) else ""


def attribute_of(of: OwnClass | OwnObject, name: str, at: Place) -> Term:
    """Return an attribute of a class or an object; unknown if it has none of that name."""
    if isinstance(of, OwnObject) and name in of.attributes:
        return of.attributes[name]
    own = of.of if isinstance(of, OwnObject) else of
    member = own.members.get(name)
    if not isinstance(member, OwnMethod):
        return _default(member, at) if member is not None else UnknownTerm(at)
    if member.kind == "classmethod":
        return _bound(member.function, own)
    if isinstance(of, OwnClass) or member.kind == "staticmethod":
        return member.function
    return member.function.call((of,), {}, None) if member.kind == "property" else _bound(member.function, of)


def _default(member: Term, at: Place) -> Term:
    """The value of an attribute of a class, which `field` of a dataclass may give."""
    if not (isinstance(member, Called) and member.short == "field"):
        return member
    factory = member.given("default_factory")
    made = factory.path if isinstance(factory, ImportedName) else ""
    if made == "list":
        return Items([], at)
    return Table(at) if made == "dict" else member.given("default") or UnknownTerm(at)


def _bound(function: Function, first: Term) -> Function:
    return function._replace(call=lambda given, keywords, context: function.call((first, *given), keywords, context))


def created(of: OwnClass, arguments: Sequence[Term], keywords: Mapping[str, Term], at: Place) -> OwnObject:
    """Return a new object of a class."""
    made = OwnObject(of, at)
    begins = "__init__"
    if of.fields is not None and begins not in of.members:
        made.attributes.update({name: attribute_of(made, name, at) for name in of.fields if name in of.members})
        made.attributes.update(zip(of.fields, arguments, strict=False))
        made.attributes.update(keywords)
        arguments, keywords, begins = (), {}, "__post_init__"
    begin = of.members.get(begins)
    if isinstance(begin, OwnMethod):
        begin.function.call((made, *arguments), keywords, None)
    return made


def assign(of: OwnObject, name: str, value: Term, *, sure: bool) -> None:
    """Give an object an attribute. sure: whether the statement is known to run."""
    old = of.attributes.get(name)
    of.attributes[name] = value if sure or old is None else one_of([old, value], value.at)
