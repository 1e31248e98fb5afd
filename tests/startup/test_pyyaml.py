"""PyYAML as we load it."""

from __future__ import annotations

import datetime as dt
import re
import subprocess
import sys

import pytest

from urdfctl.startup import lazy_yaml as pyyaml


@pytest.fixture
def fresh(monkeypatch: pytest.MonkeyPatch) -> None:
    """PyYAML's own modules as before they were imported; its library in C can be loaded only once."""
    for name in [name for name in sys.modules if name.split(".")[0] == "yaml" and name != "yaml._yaml"]:
        monkeypatch.delitem(sys.modules, name)


@pytest.mark.usefixtures("fresh")
def test_its_reader_knows_what_is_printable_though_the_pattern_is_compiled_late() -> None:
    yaml = pyyaml.load()
    reader = yaml.reader.Reader
    assert not isinstance(reader.NON_PRINTABLE, re.Pattern)
    assert yaml.load("name: Überall \U0001f916", yaml.SafeLoader) == {"name": "Überall \U0001f916"}
    with pytest.raises(yaml.YAMLError, match="special characters are not allowed"):
        yaml.load("name: a\x01b", yaml.SafeLoader)


@pytest.mark.usefixtures("fresh")
def test_it_types_values_as_ever_and_leaves_re_as_it_was() -> None:
    before = re.compile
    yaml = pyyaml.load()
    assert re.compile is before
    text = "{a: 0x1f, b: 1.5e+3, c: 2026-11-21, d: off, e: ~, f: 1e3, <<: {g: 12:30}}"
    day = dt.date(2026, 11, 21)
    known = {"a": 31, "b": 1500.0, "c": day, "d": False, "e": None, "f": "1e3", "g": 750}
    assert yaml.load(text, yaml.SafeLoader) == known
    assert yaml.safe_load(yaml.safe_dump(known)) == known


def test_what_is_loaded_already_is_taken() -> None:
    assert pyyaml.load() is sys.modules["yaml"]


def test_reading_with_libyaml_imports_neither_the_writer_nor_the_reader_in_python() -> None:
    program = """
import sys
from urdfctl.startup.lazy_yaml import yaml
assert yaml.load("a: [1, 2.5, 2026-11-21]", yaml.CSafeLoader)["a"][:2] == [1, 2.5]
try:
    yaml.load("a: [", yaml.CSafeLoader)
except yaml.MarkedYAMLError as error:
    assert error.problem_mark.line == 1
assert [type(event).__name__ for event in yaml.parse("&a x", yaml.CSafeLoader)][2] == "ScalarEvent"
print(sorted({"yaml.scanner", "yaml.emitter", "yaml.representer"} & set(sys.modules)), yaml.__with_libyaml__)
print(yaml.safe_dump(yaml.load("a: 1", yaml.SafeLoader)), sorted({"yaml.scanner", "yaml.emitter"} & set(sys.modules)))
"""
    lines = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split(
        "\n"
    )
    assert lines[0] == "[] True"
    assert lines[1] == "a: 1"
    assert lines[2] == " ['yaml.emitter', 'yaml.scanner']"


def test_a_date_is_a_date_of_the_standard_module_though_that_is_imported_late() -> None:
    program = "from urdfctl.startup.lazy_yaml import yaml; print(repr(yaml.load('2026-11-21', yaml.CSafeLoader)))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "datetime.date(2026, 11, 21)\n"
