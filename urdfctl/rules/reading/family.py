"""UC0: files that cannot be read, found or expanded."""

from __future__ import annotations

from urdfctl.fault import Fault
from urdfctl.rules.reading.argument_default_unusable import argument_default_unusable
from urdfctl.rules.reading.argument_unknown import argument_unknown
from urdfctl.rules.reading.argument_unused import argument_unused
from urdfctl.rules.reading.arguments_needed import arguments_needed
from urdfctl.rules.reading.braces_without_dollar import braces_without_dollar
from urdfctl.rules.reading.condition_not_boolean import condition_not_boolean
from urdfctl.rules.reading.doctype_with_declarations import doctype_with_declarations
from urdfctl.rules.reading.expression_fails import expression_fails
from urdfctl.rules.reading.file_not_found import file_not_found
from urdfctl.rules.reading.file_unreadable import file_unreadable
from urdfctl.rules.reading.forbidden_expression import forbidden_expression
from urdfctl.rules.reading.indentation_lost import indentation_lost
from urdfctl.rules.reading.launch_action_unused import launch_action_unused
from urdfctl.rules.reading.launch_argument_compared import launch_argument_compared
from urdfctl.rules.reading.launch_call_refused import launch_call_refused
from urdfctl.rules.reading.launch_element_malformed import launch_element_malformed
from urdfctl.rules.reading.launch_file_not_python import launch_file_not_python
from urdfctl.rules.reading.launch_name_undefined import launch_name_undefined
from urdfctl.rules.reading.macro_call_mismatch import macro_call_mismatch
from urdfctl.rules.reading.macro_defined_twice import macro_defined_twice
from urdfctl.rules.reading.macro_named_after_other_file import macro_named_after_other_file
from urdfctl.rules.reading.merge_conflict_left import merge_conflict_left
from urdfctl.rules.reading.outside_workspace import outside_workspace
from urdfctl.rules.reading.over_budget import over_budget
from urdfctl.rules.reading.package_not_found import package_not_found
from urdfctl.rules.reading.package_without_manifest import package_without_manifest
from urdfctl.rules.reading.python_tag import python_tag
from urdfctl.rules.reading.rule_crashed import rule_crashed
from urdfctl.rules.reading.suppression_unused import suppression_unused
from urdfctl.rules.reading.text_not_expanded import text_not_expanded
from urdfctl.rules.reading.undefined_argument import undefined_argument
from urdfctl.rules.reading.undefined_name import undefined_name
from urdfctl.rules.reading.unknown_macro import unknown_macro
from urdfctl.rules.reading.xacro_condition_repeated import xacro_condition_repeated
from urdfctl.rules.reading.xacro_fails import xacro_fails
from urdfctl.rules.reading.xacro_prefix_missing import xacro_prefix_missing
from urdfctl.rules.reading.xacro_warns import xacro_warns
from urdfctl.rules.reading.xml_not_well_formed import xml_not_well_formed
from urdfctl.rules.reading.yaml_key_twice import yaml_key_twice
from urdfctl.rules.reading.yaml_not_readable import yaml_not_readable
from urdfctl.rules.reading.yaml_tab import yaml_tab

FAULTS: tuple[Fault, ...] = (
    rule_crashed,
    xml_not_well_formed,
    file_not_found,
    package_not_found,
    file_unreadable,
    doctype_with_declarations,
    undefined_name,
    undefined_argument,
    unknown_macro,
    macro_call_mismatch,
    expression_fails,
    condition_not_boolean,
    xacro_fails,
    xacro_warns,
    over_budget,
    forbidden_expression,
    outside_workspace,
    macro_defined_twice,
    xacro_prefix_missing,
    argument_unused,
    braces_without_dollar,
    argument_unknown,
    xacro_condition_repeated,
    package_without_manifest,
    yaml_not_readable,
    yaml_key_twice,
    yaml_tab,
    launch_file_not_python,
    argument_default_unusable,
    macro_named_after_other_file,
    arguments_needed,
    indentation_lost,
    python_tag,
    text_not_expanded,
    merge_conflict_left,
    launch_name_undefined,
    launch_action_unused,
    launch_call_refused,
    launch_element_malformed,
    launch_argument_compared,
    suppression_unused,
)
