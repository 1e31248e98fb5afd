"""The values that a controller reads: those given of the parameters that it has, and the defaults of the others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected, matching


class Values(Mapping[str, object]):
    """By full dotted name. What the controller's distro does not read is not among them, be it given or not."""

    def __init__(self, controller: ControllerType, given: Mapping[str, object]) -> None:
        self._parameters = controller.parameters
        self._given = given

    def __getitem__(self, name: str) -> object:
        found = matching(name, self._parameters)
        if found is None:
            raise KeyError(name)
        return self._given.get(name, self._parameters[found[0]].default)

    def __iter__(self) -> Iterator[str]:
        read = (name for name in self._given if matching(name, self._parameters))
        return iter(dict.fromkeys((*expected(self._parameters, self._given), *read)))

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def is_given(self, name: str) -> bool:
        """Whether a value, known or not, is given for a parameter that is read, or for one below it."""
        return any(matching(each, self._parameters) for each in self.given_below(name))

    def given_below(self, name: str) -> list[str]:
        """The name, and those below it, that are given: of `gains` (or `gains.*`) `gains.elbow.p`."""
        bare = name.removesuffix(".*")
        return [each for each in self._given if each == bare or each.startswith(f"{bare}.")]
