"""Dependencies that must not be written, because packages would depend on each other in a circle."""

from __future__ import annotations

from collections.abc import Collection, Mapping


def closing(known: Mapping[str, Collection[str]], needed: Mapping[str, Collection[str]]) -> frozenset[tuple[str, str]]:
    """Return the needed dependencies that would close a circle with those before them, each with its package.

    known: the dependencies that packages name already, by package.
    """
    written = {package: set(names) for package, names in known.items()}
    found = set()
    for package, names in sorted(needed.items()):
        for name in sorted({*names} - written.setdefault(package, set())):
            if package in _reached(written, name):
                found.add((package, name))
            else:
                written[package].add(name)
    return frozenset(found)


def _reached(dependencies: Mapping[str, Collection[str]], start: str) -> set[str]:
    """A package, and all that it depends on."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += dependencies.get(name, ())
    return found
