"""Parse the arguments of programs that load controllers: the spawner and `ros2 control`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.model.launch import ProgramOption, Word
from urdfctl.model.launch.abbreviations import whole_option
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

WITH_VALUE = frozenset(
    (
        "-c --controller-manager -p --param-file -n --namespace -t --controller-type --controller-manager-timeout "
        "--switch-timeout --service-call-timeout --controller-ros-args --set-state --set_state --controller_manager "
        "--param_file --controller_type"
    ).split()
)
_WITHOUT_VALUE = frozenset(
    "--load-only --stopped --inactive -u --unload-on-kill --activate-as-group --switch-asap --no-switch-asap".split()
)
_OF_SPAWNER = frozenset({*(name for name in WITH_VALUE | _WITHOUT_VALUE if "_" not in name), "--controller", "--help"})
_VERBS = {
    "load_controller": None,
    "load_start_controller": True,
    "load_configure_controller": False,
    "set_controller_state": None,
}
"""The verbs of `ros2 control` that load a controller, and whether they start it; None if their arguments decide."""
_ACTIVE = frozenset({"active", "start"})
_NOT_STARTING = ("--stopped", "--inactive", "--load-only")
_OF_ROS = "--ros-args"


class SpawnerArguments(NamedTuple):
    """The parsed arguments of a spawner.

    names: the controllers.
    options: the options with their values.
    manager: the manager's name as given; None if not given. Contains UNKNOWN if it is not fully known.
    active: whether it starts the controllers.
    complete: False if some of the arguments are unknown.
    """

    names: tuple[Word, ...]
    options: tuple[ProgramOption, ...]
    manager: str | None
    active: bool
    complete: bool

    def values(self, *names: str) -> Iterator[Word]:
        """Yield the values of all options with one of these names."""
        for option in self.options:
            if option.name in names and option.value is not None:
                yield option.value


def spawner_arguments(words: Sequence[Word], *, complete: bool) -> SpawnerArguments:
    """Return the parsed arguments of a spawner.

    words: the command line after `spawner`.
    complete: False if some words are unknown.
    """
    names: list[Word] = []
    options: list[ProgramOption] = []
    rest = iter(words)
    for word in rest:
        written, mark, value = word.text.partition("=")
        name = whole_option(written, _OF_SPAWNER)
        if name == _OF_ROS:
            while (skipped := next(rest, None)) and skipped.text != "--":
                pass
        elif name == "--controller":
            given = Word(value, word.at) if mark else next(rest, None)
            names += [given] if given else []
        elif name in WITH_VALUE:
            given = Word(value, word.at) if mark else next(rest, None)
            options.append(ProgramOption(name, given, word.at))
        elif name in _WITHOUT_VALUE or name.startswith("-"):
            options.append(ProgramOption(name, None, word.at))
            complete = complete and UNKNOWN not in name
        elif word.text:
            names.append(word)
    known = tuple(word for word in names if word.known is not None)
    managers = [
        option.value.text for option in options if option.name in {"-c", "--controller-manager"} and option.value
    ]
    active = not any(option.name in _NOT_STARTING for option in options)
    return SpawnerArguments(
        known, tuple(options), managers[-1] if managers else None, active, complete and len(known) == len(names)
    )


def command_arguments(words: Sequence[Word]) -> tuple[Word, SpawnerArguments] | None:
    """Return the word with the program or verb of a command that loads controllers, and its parsed arguments.

    None if it is any other command.
    """
    texts = [word.text for word in words]
    if texts[:3] == ["ros2", "run", "controller_manager"] and texts[3:4] and texts[3] in {"spawner", "spawner.py"}:
        return words[3], spawner_arguments(words[4:], complete=True)
    if texts[:2] != ["ros2", "control"] or len(texts) < 3 or texts[2] not in _VERBS:  # noqa: PLR2004
        return None
    verb, parsed = words[2], spawner_arguments(words[3:], complete=True)
    active = _VERBS[verb.text]
    if verb.text != "set_controller_state" and parsed.names[1:]:  # newer distros: the controller, then a file
        file = ProgramOption("--param-file", parsed.names[1], parsed.names[1].at)
        parsed = parsed._replace(names=parsed.names[:1], options=(*parsed.options, file))
    if verb.text == "set_controller_state":
        state = parsed.names[1:2]
        return verb, parsed._replace(names=parsed.names[:1], active=bool(state) and state[0].text in _ACTIVE)
    if active is None:
        state = tuple(parsed.values("--set-state", "--set_state"))[-1:]
        unknown = any(word.known is None for word in state)
        parsed = parsed._replace(complete=parsed.complete and not unknown)
        active = bool(state) and state[0].text in _ACTIVE
    return verb, parsed._replace(active=active)


def manager_of(given: str | None, namespace: str) -> tuple[str | None, str | None]:
    """Return the name and the namespace of a spawner's manager; each None if unknown.

    given: the manager's name in the spawner's arguments; None for the default, `controller_manager`.
    namespace: the spawner's namespace; UNKNOWN if unknown.
    """
    name = "controller_manager" if given is None else given.strip("/") if given.startswith("/") else given
    full_name = f"/{name}" if given is not None and given.startswith("/") else f"{namespace}/{name}"
    if UNKNOWN in full_name:
        return (None if UNKNOWN in name else name.rpartition("/")[2]), None
    parts = [part for part in full_name.split("/") if part]
    return parts[-1] if parts else None, "".join(f"/{part}" for part in parts[:-1])
