"""Names that Python does not find when a launch file is started: only those that are certainly looked up."""

from __future__ import annotations

import ast
from textwrap import indent

import pytest

from urdfctl.source.launch.unbound import unbound_name

ENTRY = "generate_launch_description"


def name(body: str, before: str = "") -> str | None:
    text = f"{before}\ndef {ENTRY}():\n{indent(body, '    ')}\n"
    tree = ast.parse(text)
    found = unbound_name(tree, ast.walk(tree), ENTRY)
    return found.id if found else None


@pytest.mark.parametrize(
    "body",
    [
        "x = lost",
        "return call([{'a': lost}])",
        "if lost:\n    pass",
        "for i in lost:\n    pass",
        "with open(lost) as f:\n    pass",
        "x = f'{lost}/a'",
        "if a:\n    x = 1\ny = lost",
        "x = a if lost else b",
        "x = lost or a",
        "x: str = lost",
        "x += lost",
    ],
)
def test_a_name_that_nothing_defines_is_found_where_it_is_looked_up(body: str) -> None:
    assert name(body, "a, b, x, call = 1, 2, 3, print") == "lost"


@pytest.mark.parametrize(
    "body",
    [
        "x = a if b else lost",
        "x = a or lost",
        "x = lambda: lost",
        "x = [lost for i in []]",
        "def inner():\n    return lost",
        "if a:\n    return 1\nx = lost",
        "if a:\n    x = lost",
        "try:\n    x = lost\nexcept NameError:\n    pass",
        "return 1\nx = lost",
        "globals()['lost'] = 1\nx = lost",
        "if a:\n    lost = 1\nx = lost",
        "x = __file__, __name__, print, int",
    ],
)
def test_nothing_is_told_of_what_may_not_be_looked_up_or_may_be_defined(body: str) -> None:
    assert name(body, "a, b, x = 1, 2, 3") is None


@pytest.mark.parametrize(
    "before",
    [
        "from names import *",
        "import lost.part",
        "import a as lost",
        "def lost():\n    pass",
        "class lost:\n    pass",
        "try:\n    import lost\nexcept ImportError:\n    lost = None",
        "def set():\n    global lost\n    lost = 1",
        "for lost in []:\n    pass",
        "match 1:\n    case lost:\n        pass",
    ],
)
def test_a_name_that_the_file_defines_anywhere_is_defined(before: str) -> None:
    assert name("x = lost", before) is None


def test_the_statements_of_the_file_come_first() -> None:
    assert name("x = lost", "y = other") == "other"
