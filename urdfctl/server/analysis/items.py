"""What is offered at a place."""

from __future__ import annotations

from urdfctl.startup.records import NamedTuple


class OfferedItem(NamedTuple):
    """Something that can be written at a place.

    text: what is inserted.
    kind: what it is: link, joint, controller, type, parameter, interface, value, macro, property, argument, package,
        file or option.
    about: what is known about it, as Markdown.
    replaces: how many code points before the place it replaces: the word that is typed already.
    is_doubtful: whether it is left out if it could not be tried out, and others could.
    is_element: whether it is one element of a list, to which others may follow.
    """

    text: str
    kind: str
    about: str = ""
    replaces: int = 0
    is_doubtful: bool = False
    is_element: bool = False
