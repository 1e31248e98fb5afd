"""Turn exceptions of xacro into located problems: the node that xacro evaluated, and the meaning of the message."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.names import is_slip, nearest
from urdfctl.source.budget import OUT_OF_MEMORY, OverBudget
from urdfctl.source.disk.files import FileProblem
from urdfctl.source.disk.gate import exists
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import Place
from urdfctl.source.workspaces.packages import PackageNotFound, Packages
from urdfctl.source.xacro.blame import Blame
from urdfctl.source.xacro.expressions.guards import ForbiddenExpression, MissingVariable

_EVALUATING = r"(?s)\s*when evaluating expression '(.*)'"
_QUOTED = r"'([^']*)'"
_SPACE = re.compile(r"(?:^|/)(?:devel|install)/(?:[^/]+/)?share/([^/]+)/")
"""The path of a file that the build of a package puts there."""
_MEANT = re.compile(r"; did you mean '([^']+)'\?\Z")
_ELSEWHERE = "give its folder with --package-path, or use a wider --workspace"
_BUILT = "CMakeLists.txt names it, so the build may create it"


class AbsentFile(FileProblem, OSError):
    """The error for a file that does not exist, of the type that xacro expects."""

    def __init__(self, problem: FileProblem) -> None:
        FileProblem.__init__(self, problem.kind, problem.path, problem.message, problem.hint)


def problem_of(error: BaseException, blame: Blame, filestack: list[str]) -> Problem:
    """Return the problem that caused an exception."""
    at = blame.place(filestack)
    causes = list(causes_of(error))
    for cause in causes:
        if isinstance(cause, ReadError):
            return cause.problem
        known = _known(cause, at)
        if known is not None:
            return known
    text = str(error) or repr(error)
    expression = failed_expression(error)
    for cause in causes:
        found = _by_exception(cause, at, expression)
        if found is not None:
            return found
    return _by_text(text, at, expression)


def judged(problem: Problem, packages: Packages) -> Problem:
    """Return a problem with a package or a file as severe as it certainly is.

    A package that package.xml declares is just not in the workspace. A file in a folder that was only taken for a
    package may well exist in the real one. A file that git ignores, or that the build makes, is made later.
    """
    if problem.kind is ProblemKind.OUTSIDE_WORKSPACE and _is_made_by_build(problem.subject, packages):
        return problem._replace(message=f"{problem.message}; {_BUILT}", built=True)
    if problem.kind is ProblemKind.FILE_NOT_FOUND:
        made = _made_by(problem.subject, packages)
        problem = problem._replace(message=f"{problem.message}; {made}", built=made == _BUILT) if made else problem
        return problem._replace(guessed=bool(made) or packages.is_guessed(problem.subject))
    if problem.kind is not ProblemKind.PACKAGE_NOT_FOUND:
        return problem
    problem = _without_misfit(problem, packages)
    declared = packages.declares(problem.subject, problem.at.source.path)
    if declared is None:
        return problem
    if declared:
        return problem._replace(kind=ProblemKind.PACKAGE_ABSENT)
    here = "in this workspace"
    return problem._replace(message=problem.message.replace(here, f"{here}, and package.xml does not declare it", 1))


def _without_misfit(problem: Problem, packages: Packages) -> Problem:
    """A problem with a package without the one that is like it, if that has none of the files that are looked for,
    or of their folders where only these are known."""
    meant = _MEANT.search(problem.message)
    data, start = problem.at.source.data, problem.at.start
    text = data[start : data.find(b">", start)].decode("utf-8", "replace")
    named = re.findall(rf"\$\(find\s+{re.escape(problem.subject)}\s*\)/([^\"'<>]+)", text)
    files = [path if "$" not in path else path[: path.index("$")].rpartition("/")[0] for path in named]
    if meant is None or not any(files):
        return problem
    folder = packages.find(meant[1])
    if any(exists(os.path.join(folder, file.strip())) for file in files if file):
        return problem
    return problem._replace(message=problem.message[: meant.start()], hint=_ELSEWHERE, correct="")


def _made_by(path: str, packages: Packages) -> str:
    """What says that a missing file is made later; empty if nothing does."""
    if packages.is_ignored_by_git(path):
        return ".gitignore lists it: create it before the robot starts"
    return _BUILT if _is_made_by_build(path, packages) else ""


def _is_made_by_build(path: str, packages: Packages) -> bool:
    """Whether a missing file is one that CMakeLists.txt makes: beside it, or in the space that the build fills.

    There a file is in the folder `share` of its package: `devel/share/arm` with catkin, `install/arm/share/arm` too
    with colcon.
    """
    path = os.path.normpath(path)
    if packages.is_made_by_build(path):
        return True
    shared = _SPACE.search(path)
    try:
        folder = packages.find(shared[1]) if shared else ""
    except PackageNotFound:
        return False
    return bool(shared and packages.install_map(folder, shared[1]).makes_named(os.path.basename(path)))


def failed_expression(error: BaseException) -> str:
    """Return the innermost `${...}`, or the whole `$(...)`, that could not be evaluated; empty if there is none."""
    for cause in causes_of(error):
        substitution = getattr(cause, "substitution", None)
        if substitution is not None:
            return str(substitution)
        suffix = re.fullmatch(_EVALUATING, str(getattr(cause, "suffix", "")))
        if suffix:
            return " ".join(suffix.group(1).split())
    return ""


def causes_of(error: BaseException) -> Iterator[BaseException]:
    """Yield an exception and those that it wraps, innermost first."""
    chain: list[BaseException] = []
    current: BaseException | None = error
    while current is not None and current not in chain:
        chain.append(current)
        inner = getattr(current, "exc", None)
        current = inner if isinstance(inner, BaseException) else current.__cause__
    return reversed(chain)


def _known(cause: BaseException, at: Place) -> Problem | None:
    """Return the problem of an exception of urdfctl."""
    if isinstance(cause, FileProblem):
        return cause.at(at)
    if isinstance(cause, PackageNotFound):
        is_own = is_slip(cause.name, cause.own)
        meant = cause.own if is_own else nearest(cause.name, cause.known)
        hint = f"write '{meant}'" if meant else _ELSEWHERE
        message = f"package '{cause.name}' was not found in this workspace"
        message += f"; did you mean '{meant}'?" if meant else ""
        found = Problem(ProblemKind.PACKAGE_NOT_FOUND, at, message, cause.name, hint)
        return found._replace(correct=cause.own) if is_own else found
    if isinstance(cause, ForbiddenExpression):
        hint = "remove it, or allow it with --trust"
        return Problem(ProblemKind.FORBIDDEN_EXPRESSION, at, str(cause), hint=hint)
    if isinstance(cause, MissingVariable):
        message = f"environment variable '{cause}' is not set, or is not passed to xacro"
        return Problem(ProblemKind.UNDEFINED_VARIABLE, at, message, str(cause), f"pass it with --env {cause}")
    if isinstance(cause, OverBudget | RecursionError | MemoryError):
        return Problem(ProblemKind.BUDGET, at, f"the description cannot be expanded: {_reason(cause)}")
    return None


def _reason(cause: OverBudget | RecursionError | MemoryError) -> str:
    if isinstance(cause, OverBudget):
        return str(cause)
    return OUT_OF_MEMORY if isinstance(cause, MemoryError) else "macros or expressions are nested too deeply"


def _by_exception(cause: BaseException, at: Place, expression: str) -> Problem | None:
    said = " ".join(str(cause).split())
    if isinstance(cause, NameError):
        quoted = re.search(_QUOTED, said)
        name = quoted.group(1) if quoted else said
        message = f"'{name}' is not defined: no <xacro:property>, parameter or argument has this name here"
        return Problem(ProblemKind.UNDEFINED_NAME, at, message, name)
    if type(cause).__name__ == "ArgException":
        hint = f'declare it with <xacro:arg name="{said}" default="..."/> before its use, or pass {said}:=...'
        return Problem(ProblemKind.UNDEFINED_ARGUMENT, at, f"argument '{said}' is not defined", said, hint)
    if isinstance(cause, SyntaxError) and expression:
        return Problem(ProblemKind.EXPRESSION, at, f"'{expression}' is not a valid expression: {cause.msg}", expression)
    if type(cause).__name__ == "SubstitutionException":
        return Problem(ProblemKind.EXPRESSION, at, _lowered(said), expression)
    if expression and not type(cause).__name__.startswith("Xacro"):
        what = f"'{expression}' cannot be evaluated: {type(cause).__name__}: {said}"
        return Problem(ProblemKind.EXPRESSION, at, what, expression)
    return None


_Said = tuple[ProblemKind, str, str, str]
"""The kind, the message, the subject and the hint of a problem."""


def _by_text(text: str, at: Place, expression: str) -> Problem:
    """Return the problem that the text of xacro's message means."""
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
        return ProblemKind.UNKNOWN_MACRO, f"macro '{name}' is called before it is defined", name, hint
    if first.startswith("Invalid parameter"):
        name = first.split('"')[1]
        return ProblemKind.MACRO_CALL, f"the macro has no parameter '{name}'", name, ""
    if first.startswith("Undefined parameters"):
        names = first.partition("[")[2].partition("]")[0]
        listed = ", ".join(f"'{name}'" for name in names.split(","))
        return ProblemKind.MACRO_CALL, f"the macro call passes no value for {listed}", names, ""
    if first.startswith("Undefined property to forward:"):
        name = first.split(":", 1)[1].strip()
        return (
            ProblemKind.MACRO_CALL,
            f"the macro call passes no value for '{name}', and there is no property '{name}' to forward",
            name,
            "",
        )
    if first.startswith(("Not enough blocks", "Unused block", "Undefined block")):
        return ProblemKind.MACRO_CALL, _lowered(first).replace('"', "'"), "", ""
    return None


def _of_expression(first: str, expression: str) -> _Said | None:
    if first.startswith("Xacro conditional"):
        plain = first.replace('"', "'").replace("Xacro conditional", "condition", 1).replace("evaluated", "evaluates")
        return ProblemKind.CONDITION, plain.removesuffix(" expression."), "", ""
    if first.startswith("circular variable definition:"):
        circle = first.split(":", 1)[1].strip()
        return ProblemKind.EXPRESSION, f"properties depend on each other in a loop: {circle}", circle, ""
    if first.startswith("invalid expression:"):
        rest = first.split(":", 1)[1].strip()
        due = {"${": "'}' is missing", "$(": "')' is missing"}.get(rest[:2], "'{' or '(' is missing")
        return ProblemKind.EXPRESSION, f"'{rest}' is not a valid expression: {due}", rest, ""
    if expression:
        return ProblemKind.EXPRESSION, f"'{expression}' cannot be evaluated: {first}", expression, ""
    return None


def _lowered(sentence: str) -> str:
    return sentence[:1].lower() + sentence[1:]
