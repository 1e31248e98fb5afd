"""Problems in reading files. They are collected with their places, so that one run reports all of them."""

from __future__ import annotations

from enum import Enum, auto

from urdfctl.source.span import Place
from urdfctl.startup.records import NamedTuple


class ProblemKind(Enum):
    """The kinds of problems in reading files. Each kind is reported by one rule of the UC0 family, but for
    PACKAGE_ABSENT: a package that package.xml declares, and that is just not in the workspace, is no fault."""

    FILE_UNREADABLE = auto()
    FILE_NOT_FOUND = auto()
    PACKAGE_NOT_FOUND = auto()
    PACKAGE_ABSENT = auto()
    XML_SYNTAX = auto()
    LATE_DECLARATION = auto()
    DOCTYPE = auto()
    ENCODING = auto()
    UNDEFINED_NAME = auto()
    UNDEFINED_ARGUMENT = auto()
    UNDEFINED_VARIABLE = auto()
    ARGUMENTS_NEEDED = auto()
    UNKNOWN_MACRO = auto()
    MACRO_CALL = auto()
    EXPRESSION = auto()
    CONDITION = auto()
    XACRO = auto()
    XACRO_WARNING = auto()
    BUDGET = auto()
    FORBIDDEN_EXPRESSION = auto()
    OUTSIDE_WORKSPACE = auto()
    DUPLICATE_MACRO = auto()
    MACRO_OF_OTHER_FILE = auto()
    ARGUMENT_UNUSABLE = auto()
    UNUSED_ARGUMENT = auto()
    UNKNOWN_ARGUMENT = auto()
    MANIFEST_MISSING = auto()
    CONDITION_REPEATED = auto()
    PREFIX_MISSING = auto()
    BRACES = auto()
    YAML_SYNTAX = auto()
    YAML_DUPLICATE_KEY = auto()
    YAML_DUPLICATE_MAP = auto()
    YAML_TAB = auto()
    PYTHON_TAG = auto()
    PYTHON_SYNTAX = auto()
    PYTHON_NAME = auto()
    MERGE_CONFLICT = auto()


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
