"""What the programs that load controllers are told in their arguments: the spawner, and `ros2 control`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from urdfctl.model.launch import Option, Word
from urdfctl.record import NamedTuple
from urdfctl.source.opaque import UNKNOWN

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
_VERBS = {
    "load_controller": None,
    "load_start_controller": True,
    "load_configure_controller": False,
    "set_controller_state": None,
}
_ACTIVE = frozenset({"active", "start"})
_NOT_STARTING = ("--stopped", "--inactive", "--load-only")
_OF_ROS = "--ros-args"


class Told(NamedTuple):
    """What a spawner is told: the controllers, the options, the manager's name as it is given (None where it is not,
    UNKNOWN in it where it is not known), whether it starts them, and whether that is all."""

    names: tuple[Word, ...]
    options: tuple[Option, ...]
    manager: str | None
    active: bool
    complete: bool

    def values(self, *names: str) -> Iterator[Word]:
        """The values of all options of some names."""
        for option in self.options:
            if option.name in names and option.value is not None:
                yield option.value


def told(words: Sequence[Word], *, complete: bool) -> Told:
    """What the words behind `spawner` say; not `complete` where some of them are not known."""
    names: list[Word] = []
    options: list[Option] = []
    rest = iter(words)
    for word in rest:
        name, mark, value = word.text.partition("=")
        if name == _OF_ROS:
            while (skipped := next(rest, None)) and skipped.text != "--":
                pass
        elif name == "--controller":
            given = Word(value, word.at) if mark else next(rest, None)
            names += [given] if given else []
        elif name in WITH_VALUE:
            given = Word(value, word.at) if mark else next(rest, None)
            options.append(Option(name, given, word.at))
        elif name in _WITHOUT_VALUE or name.startswith("-"):
            options.append(Option(name, None, word.at))
            complete = complete and UNKNOWN not in name
        elif word.text:
            names.append(word)
    known = tuple(word for word in names if word.known is not None)
    managers = [
        option.value.text for option in options if option.name in {"-c", "--controller-manager"} and option.value
    ]
    active = not any(option.name in _NOT_STARTING for option in options)
    return Told(
        known, tuple(options), managers[-1] if managers else None, active, complete and len(known) == len(names)
    )


def told_by_command(words: Sequence[Word]) -> tuple[Word, Told] | None:
    """What a command line says that loads controllers, with the word that tells which; None where it is another."""
    texts = [word.text for word in words]
    if texts[:3] == ["ros2", "run", "controller_manager"] and texts[3:4] and texts[3] in {"spawner", "spawner.py"}:
        return words[3], told(words[4:], complete=True)
    if texts[:2] != ["ros2", "control"] or len(texts) < 3 or texts[2] not in _VERBS:  # noqa: PLR2004
        return None
    verb, found = words[2], told(words[3:], complete=True)
    active = _VERBS[verb.text]
    if verb.text != "set_controller_state" and found.names[1:]:  # newer distros: the controller, then a file
        given = Option("--param-file", found.names[1], found.names[1].at)
        found = found._replace(names=found.names[:1], options=(*found.options, given))
    if verb.text == "set_controller_state":
        state = found.names[1:2]
        return verb, found._replace(names=found.names[:1], active=bool(state) and state[0].text in _ACTIVE)
    if active is None:
        state = tuple(found.values("--set-state", "--set_state"))[-1:]
        unknown = any(word.known is None for word in state)
        found = found._replace(complete=found.complete and not unknown)
        active = bool(state) and state[0].text in _ACTIVE
    return verb, found._replace(active=active)


def manager_of(given: str | None, namespace: str) -> tuple[str | None, str | None]:
    """The name and namespace of the manager that a spawner means: as it is given, else `controller_manager`; both None
    where it is not known. `namespace` is the spawner's, UNKNOWN where it is not known."""
    name = "controller_manager" if given is None else given.strip("/") if given.startswith("/") else given
    whole = f"/{name}" if given is not None and given.startswith("/") else f"{namespace}/{name}"
    if UNKNOWN in whole:
        return (None if UNKNOWN in name else name.rpartition("/")[2]), None
    parts = [part for part in whole.split("/") if part]
    return parts[-1] if parts else None, "".join(f"/{part}" for part in parts[:-1])
