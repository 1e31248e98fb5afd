"""Which rule of the family reports each kind of problem: a run imports no others."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.project import Project
from urdfctl.source.problem import ProblemKind

_OF_PROBLEMS = {
    ProblemKind.FILE_UNREADABLE: "file_unreadable",
    ProblemKind.FILE_NOT_FOUND: "file_not_found",
    ProblemKind.PACKAGE_NOT_FOUND: "package_not_found",
    ProblemKind.XML_SYNTAX: "xml_not_well_formed",
    ProblemKind.LATE_DECLARATION: "xml_not_well_formed",
    ProblemKind.DOCTYPE: "doctype_with_declarations",
    ProblemKind.UNDEFINED_NAME: "undefined_name",
    ProblemKind.UNDEFINED_ARGUMENT: "undefined_argument",
    ProblemKind.UNDEFINED_VARIABLE: "undefined_argument",
    ProblemKind.ARGUMENTS_NEEDED: "arguments_needed",
    ProblemKind.UNKNOWN_MACRO: "unknown_macro",
    ProblemKind.MACRO_CALL: "macro_call_mismatch",
    ProblemKind.EXPRESSION: "expression_fails",
    ProblemKind.CONDITION: "condition_not_boolean",
    ProblemKind.XACRO: "xacro_fails",
    ProblemKind.XACRO_WARNING: "xacro_warns",
    ProblemKind.BUDGET: "over_budget",
    ProblemKind.FORBIDDEN_EXPRESSION: "forbidden_expression",
    ProblemKind.OUTSIDE_WORKSPACE: "outside_workspace",
    ProblemKind.DUPLICATE_MACRO: "macro_defined_twice",
    ProblemKind.MACRO_OF_OTHER_FILE: "macro_named_after_other_file",
    ProblemKind.ARGUMENT_UNUSABLE: "argument_default_unusable",
    ProblemKind.UNUSED_ARGUMENT: "argument_unused",
    ProblemKind.UNKNOWN_ARGUMENT: "argument_unknown",
    ProblemKind.MANIFEST_MISSING: "package_without_manifest",
    ProblemKind.CONDITION_REPEATED: "xacro_condition_repeated",
    ProblemKind.PREFIX_MISSING: "xacro_prefix_missing",
    ProblemKind.BRACES: "braces_without_dollar",
    ProblemKind.YAML_SYNTAX: "yaml_not_readable",
    ProblemKind.YAML_DUPLICATE_KEY: "yaml_key_twice",
    ProblemKind.YAML_DUPLICATE_MAP: "yaml_key_twice",
    ProblemKind.YAML_TAB: "yaml_tab",
    ProblemKind.PYTHON_SYNTAX: "launch_file_not_python",
    ProblemKind.PYTHON_NAME: "launch_name_undefined",
    ProblemKind.ACTION_UNUSED: "launch_action_unused",
    ProblemKind.ARGUMENT_COMPARED: "launch_argument_compared",
    ProblemKind.LAUNCH_FORM: "launch_element_malformed",
    ProblemKind.PYTHON_CALL: "launch_call_refused",
    ProblemKind.PYTHON_TAG: "python_tag",
    ProblemKind.MERGE_CONFLICT: "merge_conflict_left",
}
_OF_FAULTS = {
    "LOST_INDENTATION": "indentation_lost",
    "PYTHON_TAG": "python_tag",
    "UNEXPANDED": "text_not_expanded",
}
"""By the names of the kinds: most runs do not import the model of controllers."""


def rules_of(project: Project) -> Iterator[str]:
    """Yield the names of the rules that report the problems and faults of a project."""
    for problem in project.problems:
        if problem.kind in _OF_PROBLEMS:
            yield _OF_PROBLEMS[problem.kind]
    for fault in project.controllers.faults if project.controllers else ():
        if fault.kind.name in _OF_FAULTS:
            yield _OF_FAULTS[fault.kind.name]
