"""Check that the user's catalogue entries fit each other and the catalogue."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.additions import Additions
from urdfctl.catalog.catalog import catalog_with
from urdfctl.catalog.distros import ALL, in_words
from urdfctl.names import did_you_mean


def flaws_of_meaning(additions: Additions) -> Iterator[tuple[str, str]]:
    """Yield the key and a message for each inconsistency in entries that are valid against the schema.

    Reported are an `extends` that names an unknown type, and claims or rules that name a parameter the type does not
    have.
    """
    catalog = catalog_with(additions)
    for index, entry in enumerate(additions.controllers):
        base = entry.get("extends")
        if base is not None and not catalog.distros_of(entry["type"]):
            known = [name for distro in ALL for name in catalog.known_types(distro)]
            unknown = f"unknown type '{base}'{did_you_mean(base, known)}"
            elsewhere = f"'{base}' exists only in other distros: {in_words(catalog.distros_of(base))}"
            yield f"controllers[{index}].extends", elsewhere if catalog.distros_of(base) else unknown
        for distro in catalog.distros_of(entry["type"]):
            controller = catalog.controller(entry["type"], distro)
            for name in controller.undeclared if controller else ():
                hint = did_you_mean(name, controller.parameters) if controller else ""
                yield f"controllers[{index}]", f"entry uses parameter '{name}', but does not declare it{hint}"
