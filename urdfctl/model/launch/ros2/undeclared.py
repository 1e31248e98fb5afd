"""Launch configurations that are used although nothing has set them yet."""

from __future__ import annotations

from urdfctl.model.launch import Word
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

OF_SIMULATORS = frozenset(
    "gz_args gz_version ign_args ign_version debugger on_exit_shutdown world gui verbose pause server "
    "extra_gazebo_args params_file gdb init factory force_system physics profile record lockstep "
    "server_required gui_required".split()
)
"""What the launch files of simulators declare; it stays in effect after them."""


class Undeclared:
    """The names of launch configurations that are used for sure, although nothing has set them.

    launch ends at such a name (launch_configuration.py, perform()). Actions run in the order in which they are listed,
    so a name that is declared further down is not set either.
    """

    def __init__(self) -> None:
        self.words: list[Word] = []
        self._set: frozenset[str] = frozenset()
        self._is_open = False

    def __len__(self) -> int:
        return len(self.words)

    def use(self, name: str, at: Place) -> None:
        """Note a name that is used, is not set, and has no default there."""
        if not (self._is_open or UNKNOWN in name or name in self._set):
            self.words.append(Word(name, at))

    def keep(self, count: int) -> None:
        """Forget all names but the first ones: the others may not be used."""
        del self.words[count:]

    def simulate(self) -> None:
        """Take as set what the launch file of a simulator declares."""
        self._set = OF_SIMULATORS

    def stop(self) -> None:
        """Note nothing from now on: something that cannot be read may set any name."""
        self._is_open = True
