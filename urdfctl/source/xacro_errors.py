"""Turns what xacro raised into a located problem: the node it was at work on, and what the message means."""

from __future__ import annotations

import re
from collections.abc import Iterator
from types import TracebackType

from urdfctl.record import NamedTuple
from urdfctl.source.budget import OverBudget
from urdfctl.source.dom import Element, Node
from urdfctl.source.files import FileProblem
from urdfctl.source.guards import ForbiddenExpression
from urdfctl.source.packages import PackageNotFound
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Place, SourceText
from urdfctl.source.xacro_hooks import MissingVariable
from urdfctl.suggest import did_you_mean

_EVALUATING = r"(?s)\s*when evaluating expression '(.*)'"
_QUOTED = r"'([^']*)'"


class Blame(NamedTuple):
    """What xacro was at work on: a node, and the attribute of an element where that can be told."""

    node: Node | None
    attribute: str | None
    properties: tuple[str, ...] = ()

    @property
    def element(self) -> Element | None:
        """The element, or the one that a text stands in."""
        node = self.node if isinstance(self.node, Element) else self.node.parentNode if self.node else None
        return node if isinstance(node, Element) else None

    def place(self, filestack: list[str]) -> Place:
        """The attribute, the text's element, or the file where nothing nearer is known."""
        if self.element is None:
            return Place(SourceText(filestack[-1] if filestack else "", b""), 0, end=0)
        return self.element.at[self.attribute] if self.attribute else self.element.at


def blame_of(error: BaseException) -> Blame:
    """The node that the innermost evaluating frame of a traceback holds. It costs nothing where nothing is raised."""
    node: Node | None = None
    attribute: str | None = None
    properties: list[str] = []
    trace: TracebackType | None = error.__traceback__
    while trace is not None:
        values = trace.tb_frame.f_locals
        function = trace.tb_frame.f_code.co_name
        if function in ("eval_all", "handle_macro_call") and isinstance(values.get("node"), Node):
            node = values["node"]
            name = values.get("name")
            evaluates = trace.tb_next is not None and trace.tb_next.tb_frame.f_code.co_name == "eval_text"
            attribute = name if evaluates and isinstance(node, Element) and name in node.attrs else None
            properties.clear()
        elif function == "_resolve_" and isinstance(values.get("key"), str):
            properties.append(values["key"])
        trace = trace.tb_next
    return Blame(node, attribute, tuple(properties))


def problem_of(error: BaseException, blame: Blame, filestack: list[str]) -> Problem:
    """The problem behind an exception."""
    at = blame.place(filestack)
    causes = list(_causes(error))
    for cause in causes:
        if isinstance(cause, ReadError):
            return cause.problem
        known = _known(cause, at)
        if known is not None:
            return known
    text = str(error) or repr(error)
    expression = failed_expression(error)
    for cause in causes:
        found = _by_exception(cause, at, expression, blame)
        if found is not None:
            return found
    return _by_text(text, at, expression)


def failed_expression(error: BaseException) -> str:
    """The innermost `${...}`, or the whole `$(...)`, that could not be evaluated; empty where none was at work."""
    for cause in _causes(error):
        substitution = getattr(cause, "substitution", None)
        if substitution is not None:
            return str(substitution)
        suffix = re.fullmatch(_EVALUATING, str(getattr(cause, "suffix", "")))
        if suffix:
            return " ".join(suffix.group(1).split())
    return ""


def _causes(error: BaseException) -> Iterator[BaseException]:
    """The exception and those it wraps, innermost first."""
    chain: list[BaseException] = []
    current: BaseException | None = error
    while current is not None and current not in chain:
        chain.append(current)
        inner = getattr(current, "exc", None)
        current = inner if isinstance(inner, BaseException) else current.__cause__
    return reversed(chain)


def _known(cause: BaseException, at: Place) -> Problem | None:
    """The problem of an exception of our own."""
    if isinstance(cause, FileProblem):
        return cause.at(at)
    if isinstance(cause, PackageNotFound):
        hint = "name the folder it lies in with --package-path, or --workspace"
        message = f"package '{cause.name}' is not found{did_you_mean(cause.name, cause.known)}"
        return Problem(ProblemKind.PACKAGE_NOT_FOUND, at, message, cause.name, hint)
    if isinstance(cause, ForbiddenExpression):
        hint = "robot descriptions have no need of it; --trust lets it run"
        return Problem(ProblemKind.FORBIDDEN_EXPRESSION, at, str(cause), hint=hint)
    if isinstance(cause, MissingVariable):
        message = f"the environment variable '{cause}' is not set, or not passed on"
        return Problem(ProblemKind.UNDEFINED_ARGUMENT, at, message, str(cause), f"pass it on with --env {cause}")
    if isinstance(cause, OverBudget | RecursionError | MemoryError):
        said = str(cause) if isinstance(cause, OverBudget) else "macros or expressions nest too deeply"
        return Problem(ProblemKind.BUDGET, at, f"the description is not expanded: {said}")
    return None


def _by_exception(cause: BaseException, at: Place, expression: str, blame: Blame) -> Problem | None:
    said = " ".join(str(cause).split())
    if isinstance(cause, NameError):
        quoted = re.search(_QUOTED, said)
        name = quoted.group(1) if quoted else said
        via = f", needed by property '{blame.properties[-1]}'" if blame.properties else ""
        message = f"'{name}' is not defined: no <xacro:property>, parameter or argument of that name is known here{via}"
        return Problem(ProblemKind.UNDEFINED_NAME, at, message, name)
    if type(cause).__name__ == "ArgException":
        hint = f'declare it with <xacro:arg name="{said}" default="..."/> before its use, or give {said}:=...'
        return Problem(ProblemKind.UNDEFINED_ARGUMENT, at, f"argument '{said}' is not defined", said, hint)
    if isinstance(cause, SyntaxError) and expression:
        return Problem(ProblemKind.EXPRESSION, at, f"'{expression}' is no expression: {cause.msg}", expression)
    if type(cause).__name__ == "SubstitutionException":
        return Problem(ProblemKind.EXPRESSION, at, _lowered(said), expression)
    if expression and not type(cause).__name__.startswith("Xacro"):
        what = f"'{expression}' cannot be evaluated: {type(cause).__name__}: {said}"
        return Problem(ProblemKind.EXPRESSION, at, what, expression)
    return None


_Said = tuple[ProblemKind, str, str, str]
"""The kind, the message, the subject and the hint of a problem."""


def _by_text(text: str, at: Place, expression: str) -> Problem:
    """The problem behind what xacro says in words of its own."""
    first = text.split("\n", maxsplit=1)[0].strip()
    if first.startswith("Invalid parameter"):
        at = at[first.split('"')[1]]
    kind, message, subject, hint = (
        _of_macro(first) or _of_expression(first, expression) or (ProblemKind.XACRO, _lowered(first), "", "")
    )
    return Problem(kind, at, message, subject, hint)


def _of_macro(first: str) -> _Said | None:
    if first.startswith("unknown macro name:"):
        name = first.split(":", 1)[1].strip().removeprefix("xacro:")
        hint = "include the file that defines it before this line"
        return ProblemKind.UNKNOWN_MACRO, f"macro '{name}' is not defined before this call", name, hint
    if first.startswith("Invalid parameter"):
        name = first.split('"')[1]
        return ProblemKind.MACRO_CALL, f"the macro has no parameter '{name}'", name, ""
    if first.startswith("Undefined parameters"):
        names = first.partition("[")[2].partition("]")[0]
        listed = ", ".join(f"'{name}'" for name in names.split(","))
        return ProblemKind.MACRO_CALL, f"the call gives no value for {listed}", names, ""
    if first.startswith("Undefined property to forward:"):
        name = first.split(":", 1)[1].strip()
        return (
            ProblemKind.MACRO_CALL,
            f"the call gives no value for '{name}', nor is there a property to forward",
            name,
            "",
        )
    if first.startswith(("Not enough blocks", "Unused block", "Undefined block")):
        return ProblemKind.MACRO_CALL, _lowered(first).replace('"', "'"), "", ""
    return None


def _of_expression(first: str, expression: str) -> _Said | None:
    if first.startswith("Xacro conditional"):
        return ProblemKind.CONDITION, first.replace('"', "'").replace("Xacro", "the", 1), "", ""
    if first.startswith("circular variable definition:"):
        circle = first.split(":", 1)[1].strip()
        return ProblemKind.EXPRESSION, f"properties need each other in a circle: {circle}", circle, ""
    if first.startswith("invalid expression:"):
        rest = first.split(":", 1)[1].strip()
        due = {"${": "'}' is missing", "$(": "')' is missing"}.get(rest[:2], "no bracket follows it")
        return ProblemKind.EXPRESSION, f"'{rest}' is no expression: {due}", rest, ""
    if expression:
        return ProblemKind.EXPRESSION, f"'{expression}' cannot be evaluated: {first}", expression, ""
    return None


def _lowered(sentence: str) -> str:
    return sentence[:1].lower() + sentence[1:]
