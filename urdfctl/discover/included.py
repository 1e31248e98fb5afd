"""Which launch files another one includes, as far as its text says it: what each starts is not followed here."""

from __future__ import annotations

import fnmatch
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache

from urdfctl.source.workspaces.robot_starts import may_start_robot
from urdfctl.startup.records import NamedTuple

_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_INCLUDE = rb"(?s)<include\s[^<>]*?file\s*=\s*[\"']([^\"']+)[\"']"
_FOUND = r"\$\((?:find|find-pkg-share)\s+[\"']?([\w-]+)[\"']?\)"
_FOUND_BEFORE = rb"\$\(find-pkg-share\s+[\"']?([\w-]+)[\"']?\)[^\n]*\Z"
_BESIDE = r"\$\(dirname\)/[^/]*\Z"
_SUBSTITUTION = r"\$\([^)]*\)"
_SAYING = r"\w{3}.*\.launch"
"""What a name with substitutions must contain to say which files may be meant."""
_ENDINGS = rb"[._]launch\.(?:py|xml|ya?ml)"
_NAMED = rb"[\"'/]([\w.-]+" + _ENDINGS + rb")[\"']|file:[^\n#]{0,300}?/([\w.-]{1,100}" + _ENDINGS + rb")\b"
_ASKING = rb"(?:get_package_share_directory|get_package_share_path|get_package_prefix|FindPackageShare)"
_PACKAGE = _ASKING + rb"\(\s*(?:package\s*=\s*)?(?:[\"']([\w-]+)[\"']|(\w+))"
_JOINING = rb"[\s\w,/+\[\]()\"'.-]*"
_VARIABLE = rb"([A-Za-z_]\w*)[\"'}\s)]*[,/+]\s*(?:f?[\"'][^\"'\n]*[\"']\s*[,/+]\s*)*[\[(]?\s*f?[\"'/]?[\w/.-]*\Z"
_MOST_BEFORE = 240
_MOST_TEXTS = 512
_DEMO = rb"\bgenerate_demo_launch\b"
OF_DEMO = "static_virtual_joint_tfs rsp move_group moveit_rviz warehouse_db spawn_controllers".split()
"""The launch files of its package that MoveIt's demo includes (moveit_configs_utils, launches.py)."""
_ROS2 = (".py", ".yaml", ".yml")


class Included(NamedTuple):
    """The launch files that one includes.

    sure: those that it certainly includes.
    every: also those that only have the name of one that it includes.
    elsewhere: whether it seems to include one of another package that is not here and starts a robot.
    """

    sure: tuple[str, ...]
    every: tuple[str, ...]
    elsewhere: bool = False


class _Mention(NamedTuple):
    """The end of a path of a launch file, with the package that it is looked for in; None if that is not known.

    tail: in its name, `*` stands for each substitution.
    beside: whether it is in the folder of the launch file that names it.
    """

    tail: str
    package: str | None
    beside: bool = False


def included_in(path: str, text: bytes, by_name: Mapping[str, Sequence[str]]) -> Included:
    """Return the launch files that another one may include.

    by_name: the launch files there are, by their base names.
    """
    sure: list[str] = []
    every: list[str] = []
    is_ros2, elsewhere = path.endswith(_ROS2), False
    for naming in _named(text) if is_ros2 else _tails(text):
        candidates = [one for one in _like(naming.tail, by_name) if one != path]
        if naming.beside:
            candidates = [one for one in candidates if os.path.dirname(one) == os.path.dirname(path)]
        every += candidates
        if naming.package and not candidates:
            elsewhere = elsewhere or may_start_robot(naming.package, naming.tail)
        sure += _meant(path, text, naming.package, candidates) if is_ros2 else _in(naming.package, candidates)
    return Included(tuple(dict.fromkeys(sure)), tuple(dict.fromkeys(every)), elsewhere)


def _like(tail: str, by_name: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """Yield the files whose path ends with a text, in whose name `*` stands for anything."""
    folder, _, name = tail.rpartition("/")
    names = [name] if "*" not in name else fnmatch.filter(by_name, name) if re.search(_SAYING, name) else []
    ending = f"/{folder}" if folder else ""
    for candidate in (candidate for each in names for candidate in by_name.get(each, ())):
        if _folder_of(candidate, os.getcwd()).endswith(ending):
            yield candidate


def _meant(path: str, text: bytes, package: str | None, candidates: Sequence[str]) -> Iterable[str]:
    """Those that have the name of a launch file, as far as it is certain that one of them is meant.

    Without the package: the only one, or the one beside it, or the only one in a folder that is named too.
    """
    if package is not None or len(candidates) == 1:
        return _in(package, candidates)
    in_named = [one for one in candidates if any(part.encode() in text for part in one.split(os.sep)[-3:-2])]
    beside = [one for one in candidates if os.path.dirname(one) == os.path.dirname(path)]
    found = [one for one in beside if one in in_named] or in_named or beside
    return found if len(found) == 1 else ()


def _in(package: str | None, candidates: Sequence[str]) -> Iterable[str]:
    """The files in the folder of a package; all of them if it is not known."""
    if package is None:
        return candidates
    return [one for one in candidates if package in os.path.abspath(one).split(os.sep)]


@lru_cache(maxsize=_MOST_TEXTS)
def _tails(text: bytes) -> tuple[_Mention, ...]:
    """The ends of the paths that an XML launch file includes. Texts are kept: each package's search reads them."""
    addresses = re.findall(_INCLUDE, re.sub(_COMMENT, b"", text))
    return tuple(_of_address(address.decode("utf-8", "replace")) for address in addresses)


def _of_address(address: str) -> _Mention:
    found = re.match(_FOUND, address)
    folders, slash, name = address.rpartition("/")
    folder = re.sub(r"^.*\$\([^)]*\)+/?", "", folders + slash).lstrip("./")
    tail = folder + re.sub(_SUBSTITUTION, "*", name)
    return _Mention(tail, found[1] if found else None, re.match(_BESIDE, address) is not None)


@lru_cache(maxsize=_MOST_TEXTS)
def _folder_of(path: str, current: str) -> str:
    """The folder of a path relative to the current folder, from the root."""
    return os.path.dirname(os.path.normpath(os.path.join(current, path))).replace(os.sep, "/")


@lru_cache(maxsize=_MOST_TEXTS)
def _named(text: bytes) -> tuple[_Mention, ...]:
    """The names of launch files in a Python or YAML launch file, with the packages that they are looked for in."""
    found = [
        _Mention((match[1] or match[2]).decode("utf-8", "replace"), _package_of(text, match))
        for match in re.finditer(_NAMED, text)
    ]
    demo = [_Mention(f"{name}.launch.py", None) for name in OF_DEMO if re.search(_DEMO, text)]
    return tuple(dict.fromkeys([*found, *demo]))


def _package_of(text: bytes, named: re.Match[bytes]) -> str | None:
    """The package that the address of a launch file asks for; None if it is not known."""
    end = named.start(1) if named[1] else named.start(2)
    address = re.search(_FOUND_BEFORE, text[max(0, end - _MOST_BEFORE) : end])
    return address[1].decode("utf-8", "replace") if address else _package_before(text, named.start())


def _package_before(text: bytes, end: int) -> str | None:
    """The package that an expression with the name of a launch file at its end asks for; None if it is not known."""
    before = text[max(0, end - _MOST_BEFORE) : end]
    asked = [match for match in re.finditer(_PACKAGE, before) if re.fullmatch(_JOINING, before[match.end() :])]
    if asked:
        return _literal(text, asked[-1])
    variable = re.search(_VARIABLE, before)
    if variable is None:
        return None
    assigned = re.search(rb"\b" + re.escape(variable[1]) + rb"\s*=\s*[^=]{0,200}?" + _PACKAGE, text)
    return _literal(text, assigned) if assigned else None


def _literal(text: bytes, match: re.Match[bytes]) -> str | None:
    """The name of a package that is given as text, or as a variable that is set to one."""
    name = match[1]
    if name is None:
        value = re.search(rb"\b" + re.escape(match[2]) + rb"\s*=\s*[\"']([\w-]+)[\"']", text)
        name = value and value[1]
    return name.decode("utf-8", "replace") if name else None
