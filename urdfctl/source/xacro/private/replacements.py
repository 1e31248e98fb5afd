"""Every name of the installed xacro that an expansion replaces in its private copy, and why.

location: so that each element knows where it was written, and by which calls.
safety: so that an untrusted expression cannot run code, read outside the workspace, or never end.
speed: the same result, faster.
without-ros: packages and the environment, as a linter sees them.
findings: so that a problem is kept instead of printed.

A test compares a private copy with the installed xacro: no other name may differ.
"""

from __future__ import annotations

from typing import Any

from urdfctl.startup.records import NamedTuple


class Replacement(NamedTuple):
    """A name of xacro that is replaced.

    name: in the module xacro; after a dot, in a class of it, or in the part `substitution_args`.
    why: the reason, and what the replacement does.
    """

    name: str
    reason: str
    why: str


REPLACEMENTS = (
    Replacement("parse", "location", "reads a file into located nodes, within the workspace"),
    Replacement("process_include", "location", "opens a call, so that what is included knows its include"),
    Replacement("handle_macro_call", "location", "opens a call, so that what a macro writes knows its call"),
    Replacement("resolve_macro", "location", "remembers the definition of the macro that is called"),
    Replacement("replace_node", "location", "remembers which <xacro:attribute> wrote an attribute"),
    Replacement("check_attrs", "location", "sees each xacro element before it is evaluated; counts inserted blocks"),
    Replacement("_empty_text_node", "location", "our own kind of text node"),
    Replacement("grab_macro", "findings", "remembers macros, and reports one that is defined twice"),
    Replacement("eval_all", "findings", "keeps the first problem of an element and goes on after it"),
    Replacement("warning", "findings", "keeps a warning with its place"),
    Replacement("error", "findings", "keeps an error with its place"),
    Replacement("message", "findings", "prints nothing"),
    Replacement("print_location", "findings", "prints nothing"),
    Replacement(
        "Table._resolve_", "findings", "forgets a look-up that failed; the next one would report a false circle"
    ),
    Replacement("safe_eval", "safety", "evaluates only what the allow-list admits, with guarded operators"),
    Replacement("_global_symbols", "safety", "guarded builtins and a guarded math"),
    Replacement("tokenize", "safety", "separators cannot change the pattern that they become part of"),
    Replacement("glob", "safety", "lists files only where they may be read"),
    Replacement("load_yaml", "safety", "reads a YAML file only where it may be read, and by libyaml if possible"),
    Replacement("eval_text", "speed", "returns text without `$` at once; uses the cached lexer"),
    Replacement("is_valid_name", "speed", "asks str.isidentifier instead of compiling an expression"),
    Replacement("deepcopy", "speed", "copies lists, which is all that xacro copies"),
    Replacement("parse_macro_arg", "speed", "splits quoted params in linear time, also for safety"),
    Replacement("eval_extension", "without-ros", "loads substitution_args late, and remembers what failed"),
    Replacement("substitution_args._eval_find", "without-ros", "finds packages without ROS"),
    Replacement("substitution_args._eval_env", "without-ros", "sees only the variables that are passed on"),
    Replacement("substitution_args._eval_optenv", "without-ros", "sees only the variables that are passed on"),
    Replacement("substitution_args._eval_dict", "without-ros", "names the three functions above"),
    Replacement("substitution_args._eval", "safety", "evaluates $(eval ...) behind the same allow-list"),
)
_NAMES = frozenset(replacement.name for replacement in REPLACEMENTS)


def replace(owner: Any, name: str, value: object, *, within: str = "") -> None:
    """Set a name of a private xacro, which has to be in the table.

    owner: the module, a class of it, or its part `substitution_args`.
    within: the name of that class or part.
    """
    if (f"{within}.{name}" if within else name) not in _NAMES:
        raise KeyError(name)
    setattr(owner, name, value)
