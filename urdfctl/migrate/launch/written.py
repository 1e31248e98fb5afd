"""What a migration writes into a launch file."""

from __future__ import annotations

from urdfctl.migrate.launch.actions import Action
from urdfctl.migrate.launch.python_form import python_file
from urdfctl.migrate.launch.xml_form import xml_file
from urdfctl.startup.records import NamedTuple


class WrittenLaunch(NamedTuple):
    """What a migration writes into a launch file.

    about: the first line of the file's docstring, or its first comment.
    todos: the comments above the actions.
    actions: the actions, in order.
    """

    about: str
    todos: tuple[str, ...]
    actions: tuple[Action, ...]


def as_python(written: WrittenLaunch) -> str:
    """Return a launch file in Python."""
    text = python_file(written.actions, written.about)
    if not written.todos:
        return text
    head, mark, rest = text.partition('"""\n')
    return head + mark + "\n" + "".join(f"{todo}\n" for todo in written.todos) + rest.lstrip("\n")


def as_xml(written: WrittenLaunch) -> str:
    """Return a launch file in XML."""
    head, mark, rest = xml_file(written.actions, written.about).partition("<launch>\n")
    return head + mark + "".join(f"  {todo}\n" for todo in written.todos) + rest
