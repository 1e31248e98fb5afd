"""The words in the names of joints and links, and the sides that they say."""

from __future__ import annotations

import re

SIDES = {
    **dict.fromkeys(("l", "left"), "left_"),
    **dict.fromkeys(("r", "right"), "right_"),
    **dict.fromkeys(("fl", "lf"), "front_left_"),
    **dict.fromkeys(("fr", "rf"), "front_right_"),
    **dict.fromkeys(("rl", "hl", "lh", "bl", "lb"), "rear_left_"),
    **dict.fromkeys(("rr", "hr", "rh", "br", "rb"), "rear_right_"),
}
"""The words in names that say on which side a part is."""
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")


def words_of(name: str) -> list[str]:
    """Return the words of a name in lower case, also of one in camelCase."""
    return [word.lower() for word in _WORD.findall(name)]
