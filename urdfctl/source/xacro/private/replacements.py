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


class ReplacedName(NamedTuple):
    """A name of xacro that is replaced.

    name: in the module xacro; after a dot, in a class of it, or in the part `substitution_args`.
    why: the reason, and what the replacement does.
    """

    name: str
    reason: str
    why: str


REPLACEMENTS = (
    ReplacedName("parse", "location", "reads a file into located nodes, within the workspace"),
    ReplacedName("process_include", "location", "opens a call, so that what is included knows its include"),
    ReplacedName("handle_macro_call", "location", "opens a call, so that what a macro writes knows its call"),
    ReplacedName("resolve_macro", "location", "remembers the definition of the macro that is called"),
    ReplacedName("replace_node", "location", "remembers which <xacro:attribute> wrote an attribute"),
    ReplacedName("check_attrs", "location", "sees each xacro element before it is evaluated; counts inserted blocks"),
    ReplacedName("_empty_text_node", "location", "our own kind of text node"),
    ReplacedName("grab_macro", "findings", "remembers macros, and reports one that is defined twice"),
    ReplacedName("eval_all", "findings", "keeps the first problem of an element and goes on after it"),
    ReplacedName("warning", "findings", "keeps a warning with its place"),
    ReplacedName("error", "findings", "keeps an error with its place"),
    ReplacedName("message", "findings", "prints nothing"),
    ReplacedName("print_location", "findings", "prints nothing"),
    ReplacedName(
        "Table._resolve_", "findings", "forgets a look-up that failed; the next one would report a false circle"
    ),
    ReplacedName("safe_eval", "safety", "evaluates only what the allow-list admits, with guarded operators"),
    ReplacedName("_global_symbols", "safety", "guarded builtins and a guarded math"),
    ReplacedName("tokenize", "safety", "separators cannot change the pattern that they become part of"),
    ReplacedName("glob", "safety", "lists files only where they may be read"),
    ReplacedName("load_yaml", "safety", "reads a YAML file only where it may be read, and by libyaml if possible"),
    ReplacedName("eval_text", "speed", "returns text without `$` at once; uses the cached lexer"),
    ReplacedName("is_valid_name", "speed", "asks str.isidentifier instead of compiling an expression"),
    ReplacedName("deepcopy", "speed", "copies lists, which is all that xacro copies"),
    ReplacedName("parse_macro_arg", "speed", "splits quoted params in linear time, also for safety"),
    ReplacedName("eval_extension", "without-ros", "loads substitution_args late, and remembers what failed"),
    ReplacedName("substitution_args._eval_find", "without-ros", "finds packages without ROS"),
    ReplacedName("substitution_args._eval_env", "without-ros", "sees only the variables that are passed on"),
    ReplacedName("substitution_args._eval_optenv", "without-ros", "sees only the variables that are passed on"),
    ReplacedName("substitution_args._eval_dict", "without-ros", "names the three functions above"),
    ReplacedName("substitution_args._eval", "safety", "evaluates $(eval ...) behind the same allow-list"),
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
