"""The addresses of controller files in their packages, and what is said of those that the manager does not get."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.step import EntryKind, ReportEntry
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.source.xml.dom import Element


def addresses(paths: Iterable[str]) -> list[str]:
    """Return the addresses of files as xacro writes them, each once; none for a file in no package."""
    return [address for path in dict.fromkeys(paths) if (address := _address(path))]


def _address(path: str) -> str | None:
    folder = package_around(os.path.dirname(path))
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    return f"$(find {name})/{os.path.relpath(path, folder).replace(os.sep, '/')}" if folder and name else None


def declared_again(plugin: Element, files: list[str], robots: Iterable[LoadedTarget]) -> Iterator[ReportEntry]:
    """Yield the entries on the files of launch files that a manager does not get: they declare its controllers again.

    files: the addresses of those that it gets.
    """
    declared = list(dict.fromkeys(_declared(robots)))
    chosen = {name: address for name, address in reversed(declared) if address in files}
    others = {address: chosen[name] for name, address in declared if address not in files and name in chosen}
    for other, its in others.items():
        message = f"the manager loads '{its}', and not '{other}', which declares the same controllers"
        yield ReportEntry(EntryKind.DECIDED, message, plugin.at, option=f"<parameters>{other}</parameters>")


def _declared(robots: Iterable[LoadedTarget]) -> Iterator[tuple[str, str]]:
    """The controllers that launch files load for some robots, with the addresses of their files."""
    for started in (one.project.controllers for one in robots if one.project.controllers):
        for each in started.controllers:
            address = _address(each.declared_at.source.path) if each.declared_at is not None else None
            if address is not None:
                yield each.full_name, address
