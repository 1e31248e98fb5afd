"""The files with the parameters of controllers, which their spawners pass on from jazzy on."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from urdfctl.catalog.moves import MANAGER
from urdfctl.generate.files.bringup import takes_param_file
from urdfctl.migrate.launch.actions import Action, Text, all_actions, is_literal, literal, parsed, plain
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.controller_files import installed_path, sections, sections_near
from urdfctl.source.span import SourceText

_OPTION = "--param-file"
_FLAGS = ("--inactive", "--activate-as-group", "--unload-on-kill", "-u")
"""The options of a spawner without a value."""


def with_parameter_files(packages: MigratedPackages, source: SourceText, actions: Sequence[Action]) -> list[Action]:
    """Return the actions of a launch file, in which each spawner passes on the files of its controllers.

    The files of a spawner are those that it may need: it passes them on if its controllers or their files are unknown.
    """
    known = sections_near([one for one in packages.found(sections) if one.type != MANAGER], source, source.data)
    arguments = (action for action in all_actions(tuple(actions)) if action.kind == "argument")
    defaults = {action.name: plain(action.value) for action in arguments if action.value and is_literal(action.value)}
    is_passed = takes_param_file(packages.options.target)

    def passing(action: Action) -> Action:
        if action.kind == "group":
            return action._replace(inner=tuple(map(passing, action.inner)))
        if (action.package, action.name) != ("controller_manager", "spawner"):
            return action
        files = _files(packages, action, defaults, known) if is_passed else ()
        more = [word for file in files for word in (literal(_OPTION), file)]
        return action._replace(words=(*action.words, *more), files=())

    return [passing(action) for action in actions]


def _files(
    packages: MigratedPackages, spawner: Action, defaults: Mapping[str, str], known: Mapping[str, Collection[str]]
) -> Sequence[Text]:
    if literal(_OPTION) in spawner.words:
        return ()
    names = list(_names(spawner.words, defaults))
    found = [known[name] for name in names if name in known]
    is_chosen = any(part.kind not in ("find", "text") for file in spawner.files for part in file)
    if is_chosen or not all(names) or any(len(files) > 1 for files in found):
        return spawner.files
    paths = dict.fromkeys(path for files in found for path in files)
    declaring = [_address(packages, path) for path in paths]
    is_loaded = not spawner.files or not declaring or any(file in spawner.files for file in declaring)
    return declaring if is_loaded else spawner.files


def _names(words: Sequence[Text], defaults: Mapping[str, str]) -> Iterator[str]:
    """The names of the controllers that a spawner starts; an empty one if one is not known."""
    rest = iter(words)
    for word in rest:
        if plain(word) in _FLAGS:
            continue
        if plain(word).startswith("-"):
            next(rest, None)
            continue
        is_argument = len(word) == 1 and word[0].kind == "arg"
        text = plain(word) if is_literal(word) else defaults.get(word[0].text, "") if is_argument else ""
        yield from text.split() or [""]


def _address(packages: MigratedPackages, path: str) -> Text:
    package, parts = installed_path(packages, path)
    return parsed(f"$(find {package})/{'/'.join(parts)}")
