"""Problems in reading files. They are collected with their places, so that one run reports all of them."""

from __future__ import annotations

from enum import Enum

from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class ProblemKind(Enum):
    """The kinds of problems in reading files. Each kind is reported by one rule of the UC0 family, but for
    PACKAGE_ABSENT: a package that package.xml declares, and that is just not in the workspace, is no fault."""

    FILE_UNREADABLE = "file unreadable"
    FILE_NOT_FOUND = "file not found"
    PACKAGE_NOT_FOUND = "package not found"
    PACKAGE_ABSENT = "package absent"
    XML_SYNTAX = "xml syntax"
    LATE_DECLARATION = "late declaration"
    DOCTYPE = "doctype"
    ENCODING = "encoding"
    UNDEFINED_NAME = "undefined name"
    UNDEFINED_ARGUMENT = "undefined argument"
    UNDEFINED_VARIABLE = "undefined variable"
    ARGUMENTS_NEEDED = "arguments needed"
    UNKNOWN_MACRO = "unknown macro"
    MACRO_CALL = "macro call"
    EXPRESSION = "expression"
    CONDITION = "condition"
    XACRO = "xacro"
    XACRO_WARNING = "xacro warning"
    BUDGET = "budget"
    FORBIDDEN_EXPRESSION = "forbidden expression"
    OUTSIDE_WORKSPACE = "outside workspace"
    DUPLICATE_MACRO = "duplicate macro"
    MACRO_OF_OTHER_FILE = "macro of other file"
    ARGUMENT_UNUSABLE = "argument unusable"
    UNUSED_ARGUMENT = "unused argument"
    UNKNOWN_ARGUMENT = "unknown argument"
    MANIFEST_MISSING = "manifest missing"
    CONDITION_REPEATED = "condition repeated"
    PREFIX_MISSING = "prefix missing"
    BRACES = "braces"
    YAML_SYNTAX = "yaml syntax"
    YAML_DUPLICATE_KEY = "yaml duplicate key"
    YAML_DUPLICATE_MAP = "yaml duplicate map"
    YAML_TAB = "yaml tab"
    PYTHON_TAG = "python tag"
    PYTHON_SYNTAX = "python syntax"
    PYTHON_NAME = "python name"
    ACTION_UNUSED = "action unused"
    ARGUMENT_COMPARED = "argument compared"
    LAUNCH_FORM = "launch form"
    PYTHON_CALL = "python call"
    MERGE_CONFLICT = "merge conflict"


class Problem(NamedTuple):
    """One problem in reading a file.

    kind: decides which rule reports it.
    at: where it is.
    message: what is wrong.
    subject: the name that it is about, if any.
    hint: how to solve it, if known.
    guessed: True if it depends on a guess, so that it is no error for sure.
    built: True if the build of a package probably makes the file that is missing.
    follows: how many more problems it caused, which are not told.
    also: other places in the same file with the same problem.
    used: where the text at `at` is used, if elsewhere.
    meant: the name that probably belongs in the place of the subject; empty if none does.
    correct: the name that certainly belongs there; empty if that is not certain.
    """

    kind: ProblemKind
    at: Place
    message: str
    subject: str = ""
    hint: str = ""
    guessed: bool = False
    follows: int = 0
    also: tuple[Place, ...] = ()
    used: Place | None = None
    meant: str = ""
    correct: str = ""
    built: bool = False


class ReadError(Exception):
    """Reading cannot go on because of a problem; a caller that can go on without the result records the problem."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem
