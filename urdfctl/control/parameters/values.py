"""The parameter values that a controller reads: given values, and defaults for the other parameters."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping
from itertools import islice, takewhile

from urdfctl.catalog.entries import ControllerType
from urdfctl.catalog.map_parameters import expected, matching


class Values(Mapping[str, object]):
    """Values by full dotted name. Parameters that the controller's distro does not read are left out, even if given."""

    def __init__(self, controller: ControllerType, given: Mapping[str, object]) -> None:
        self._parameters = controller.parameters
        self._given = given
        self._sorted: list[tuple[str, int]] | None = None

    def __getitem__(self, name: str) -> object:
        matched = matching(name, self._parameters)
        if matched is None:
            raise KeyError(name)
        return self._given.get(name, self._parameters[matched[0]].default)

    def __iter__(self) -> Iterator[str]:
        read = (name for name in self._given if matching(name, self._parameters))
        return iter(dict.fromkeys((*expected(self._parameters, self._given), *read)))

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def is_given(self, name: str) -> bool:
        """Return whether a value, even an unknown one, is given for a known parameter of this name, or one below it."""
        return any(matching(each, self._parameters) for each in self.given_below(name))

    def given_below(self, name: str) -> list[str]:
        """Return the given names equal to a name or below it: for `gains` (or `gains.*`) `gains.elbow.p`."""
        bare = name.removesuffix(".*")
        if self._sorted is None:
            self._sorted = sorted((each, number) for number, each in enumerate(self._given))
        start = f"{bare}."
        found = takewhile(
            lambda one: one[0].startswith(start), islice(self._sorted, bisect_left(self._sorted, (start,)), None)
        )
        below = [each for each, _ in sorted(found, key=lambda one: one[1])]
        return [bare, *below] if bare in self._given else below
