"""Declare an option once, as an attribute of its command's class: help, completion and reading all follow from it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from enum import Enum
from typing import TYPE_CHECKING, Any, ClassVar

from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from typing_extensions import Self, dataclass_transform
else:

    def dataclass_transform(**_: object) -> Callable[[type], type]:
        """Return what leaves a class alone: it speaks to type checkers."""
        return lambda cls: cls


CHECKED_FOR = "What it is checked for"
RULES = "Rules"
FIXES = "Fixes"
JOINTS = "Joints"
CONTROLLERS = "Controllers"
OUTPUT = "Output"
EXIT = "Exit status and known findings"
LIMITS = "Files and limits"
OTHER = "Other"
GROUPS = (CHECKED_FOR, RULES, FIXES, JOINTS, CONTROLLERS, OUTPUT, EXIT, LIMITS, OTHER)
"""The groups of options, in the order of the help."""


class Reads(Enum):
    """What a command may read because of the value of an option."""

    NOTHING = "nothing"
    WORKSPACE = "the workspace of the file or folder"
    WORKSPACE_OF_LINE = "the workspace of the file that all the words together name"
    PLACE = "just this file or folder"
    PLACE_AFTER_NAME = "just the file after NAME="
    TARGET = "just this file or folder, which it writes; what writes it looks at its links"


_TYPES: Mapping[str, tuple[type, bool, object]] = {
    "bool": (bool, False, False),
    "bool | None": (bool, False, None),
    "str": (str, False, None),
    "str | None": (str, False, None),
    "int": (int, False, None),
    "int | None": (int, False, None),
    "float": (float, False, None),
    "tuple[str, ...]": (str, True, ()),
}
"""The types that an option can be annotated with: the type of one value, whether there may be several, the default."""


_BY_NAME = ("--",)
"""The flags of an option that is called as its attribute is."""


class Option(NamedTuple):
    """An option of a command, or what it takes without a flag: an argument, such as a path.

    flags: the names on the command line; empty for an argument.
    type: of one value: bool, int, float or str.
    is_list: it can be repeated, and each time adds a value.
    is_required: it has to be given.
    default: the value if it is not given; None if there is none.
    help: a sentence, with the default if that is not plain.
    group: one of `GROUPS`.
    choices: the values that the help lists and a shell completes. The command checks them.
    is_open: there are other values than the choices.
    metavar: what the help shows for the value.
    bounds: the least and the greatest number.
    reads: what the command may read because of it.
    hidden: the help does not show it.
    of: the commands that have it, by name; empty for all whose class has it.
    """

    help: str
    flags: tuple[str, ...] = ()
    group: str = OTHER
    default: Any = None
    type: type = str
    is_list: bool = False
    is_required: bool = False
    choices: tuple[str, ...] = ()
    is_open: bool = False
    metavar: str | None = None
    bounds: tuple[int, int] | None = None
    reads: Reads = Reads.NOTHING
    hidden: bool = False
    of: Collection[str] = ()

    @property
    def negatives(self) -> tuple[str, ...]:
        """The flags that switch it off: of a switch that may be on without being named."""
        if self.type is not bool or self.default is False:
            return ()
        return tuple(f"--no-{flag.removeprefix('--')}" for flag in self.flags)


def option(  # noqa: PLR0913 (each says another thing of an option)
    group: str,
    help: str,  # noqa: A002 (the name that typer and argparse use)
    *flags: str,
    default: Any = None,
    choices: Sequence[str] = (),
    is_open: bool = False,
    metavar: str | None = None,
    bounds: tuple[int, int] | None = None,
    reads: Reads = Reads.NOTHING,
    hidden: bool = False,
    of: Collection[str] = (),
) -> Any:
    """Return an option, as the value of a class's attribute: its annotation is the type of the option.

    flags: the names on the command line if that is not the attribute's, `--fail-on` for `fail_on`. For the others, see
    `Option`.
    """
    return Option(
        help=help,
        flags=flags or _BY_NAME,
        group=group,
        default=default,
        choices=tuple(choices),
        is_open=is_open,
        metavar=metavar,
        bounds=bounds,
        reads=reads,
        hidden=hidden,
        of=of,
    )


def argument(
    help: str,  # noqa: A002 (the name that typer and argparse use)
    *,
    metavar: str | None = None,
    default: Any = None,
    choices: Sequence[str] = (),
    is_required: bool = False,
    reads: Reads = Reads.WORKSPACE,
) -> Any:
    """Return what is taken without a flag, as the value of a class's attribute. For what it is, see `Option`."""
    return Option(help, default=default, metavar=metavar, choices=tuple(choices), is_required=is_required, reads=reads)


@dataclass_transform(frozen_default=True, kw_only_default=True, field_specifiers=(option, argument))
class Options:
    """The options of a command, and what they are in one run: a class for each command, its docstring is the help.

    Attributes whose value is an `option` or an `argument` are the options, also those of base classes. An object has
    their values, and does not change.
    """

    declared: ClassVar[Mapping[str, Option]] = {}
    """The options by the names of their attributes, in the order of the help."""
    is_bounded: ClassVar[bool] = True
    """Whether what the process may read follows from its options. Otherwise it may read nothing but what it admits."""

    def __init_subclass__(cls, *, command: str = "") -> None:
        """Collect the options. command: its name, for a class with options that not all commands have."""
        found = dict[str, Option]()
        for base in reversed(cls.__mro__[1:]):
            found |= vars(base).get("declared", {})
        for name, annotation in cls.__annotations__.items():
            given = cls.__dict__.get(name)
            if isinstance(given, Option):
                found[name] = _typed(given, f"{cls.__name__}.{name}", annotation)
                setattr(cls, name, found[name].default)
        cls.declared = {name: one for name, one in found.items() if not (command and one.of) or command in one.of}

    def __init__(self, **given: Any) -> None:
        unknown = given.keys() - self.declared.keys()
        if unknown:
            raise TypeError(f"{type(self).__name__} has no option {', '.join(sorted(unknown))}")
        vars(self).update(given)

    if not TYPE_CHECKING:  # checkers know that it is frozen

        def __setattr__(self, name: str, _value: object) -> None:
            raise AttributeError(f"{type(self).__name__}.{name} cannot be changed")

    def values(self) -> dict[str, Any]:
        """Return the value of each option by its name."""
        return {name: getattr(self, name) for name in self.declared}

    def changed(self, **given: Any) -> Self:
        """Return the same options but for some values."""
        return type(self)(**{**self.values(), **given})

    @classmethod
    def plain_words(cls, given: Sequence[str]) -> Sequence[str]:
        """Return the words of a command line as all commands write them."""
        return given


def _typed(given: Option, attribute: str, annotation: str) -> Option:
    """An option with what its attribute's name and annotation say."""
    if annotation not in _TYPES:
        raise TypeError(f"the type of {attribute} is '{annotation}'; known are {', '.join(_TYPES)}")
    kind, is_list, default = _TYPES[annotation]
    name = attribute.rpartition(".")[2]
    flags = (f"--{name.replace('_', '-')}",) if given.flags == _BY_NAME else given.flags
    repeats = is_list and flags and "Repeatable." not in given.help
    return given._replace(
        flags=flags,
        type=kind,
        is_list=is_list,
        default=default if given.default is None else given.default,
        help=f"{given.help} Repeatable." if repeats else given.help,
    )


class Command(NamedTuple):
    """A command: the class of its options, and what it does with them. It returns the exit status."""

    options: type[Options]
    run: Callable[[Any], int]
