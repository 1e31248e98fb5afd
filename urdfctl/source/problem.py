"""What reading met and could not make sense of: kept with its place, so that one run tells all of it."""

from __future__ import annotations

from enum import Enum, auto

from urdfctl.record import NamedTuple
from urdfctl.source.span import Place


class ProblemKind(Enum):
    """The kinds of problems that reading can meet; each has one rule of the family UC0."""

    FILE_UNREADABLE = auto()
    FILE_NOT_FOUND = auto()
    PACKAGE_NOT_FOUND = auto()
    XML_SYNTAX = auto()
    LATE_DECLARATION = auto()
    DOCTYPE = auto()
    ENCODING = auto()
    UNDEFINED_NAME = auto()
    UNDEFINED_ARGUMENT = auto()
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
    PYTHON_SYNTAX = auto()


class Problem(NamedTuple):
    """One thing that reading met. `subject` is the name it is about, `hint` the way out where there is one."""

    kind: ProblemKind
    at: Place
    message: str
    subject: str = ""
    hint: str = ""


class ReadError(Exception):
    """Carries a problem up to whoever can keep it and go on."""

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem.message)
        self.problem = problem
