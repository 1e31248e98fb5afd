"""What the user adds to the catalogue, as plain entries in the form of its data."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.suggest import did_you_mean

Plain = Mapping[str, Any]


class Additions(NamedTuple):
    """Entries of controllers and of hardware plugins."""

    controllers: tuple[Plain, ...] = ()
    hardware: tuple[Plain, ...] = ()


NO_ADDITIONS = Additions()


def flaws_of_meaning(additions: Additions) -> Iterator[tuple[str, str]]:
    """What is wrong with entries that obey the schema, each with its key: types that are extended and not known, and
    parameters that claims and rules speak of and nobody declares."""
    from urdfctl.catalog.catalog import catalog_with
    from urdfctl.catalog.distros import ALL, in_words

    catalog = catalog_with(additions)
    for index, entry in enumerate(additions.controllers):
        base = entry.get("extends")
        if base is not None and not catalog.distros_of(entry["type"]):
            known = [name for distro in ALL for name in catalog.known_types(distro)]
            wrong = f"unknown type '{base}'{did_you_mean(base, known)}"
            elsewhere = f"the distros of '{base}' are others: {in_words(catalog.distros_of(base))}"
            yield f"controllers[{index}].extends", elsewhere if catalog.distros_of(base) else wrong
        for distro in catalog.distros_of(entry["type"]):
            controller = catalog.controller(entry["type"], distro)
            for name in controller.undeclared if controller else ():
                near = did_you_mean(name, controller.parameters) if controller else ""
                yield f"controllers[{index}]", f"it speaks of '{name}', which is none of its parameters{near}"
