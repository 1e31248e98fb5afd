"""Modules are imported from their compiled files, if these are the ones that Python itself would use."""

from __future__ import annotations

import importlib
import os
import py_compile
import sys
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from types import ModuleType

import pytest

from urdfctl.startup import quick_imports

SOURCE = "VALUE = 1\n"


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A package `quick` with a module `a`, whose modules are imported quickly."""
    folder = tmp_path / "quick"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    (folder / "a.py").write_text(SOURCE)
    monkeypatch.setattr(sys, "path", [str(tmp_path), *sys.path])
    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path])
    monkeypatch.setattr(sys, "pycache_prefix", None)
    quick_imports.import_quickly(("quick.",))
    yield folder
    for name in [name for name in sys.modules if name.partition(".")[0] == "quick"]:
        del sys.modules[name]


def imported() -> ModuleType:
    sys.modules.pop("quick.a", None)
    importlib.invalidate_caches()
    return importlib.import_module("quick.a")


def is_quick(module: ModuleType) -> bool:
    return type(module.__loader__).__module__ == "urdfctl.startup.quick_imports"


def test_a_compiled_module_is_imported_quickly_and_looks_like_any_other(package: Path) -> None:
    compiled = py_compile.compile(str(package / "a.py"), doraise=True)
    module = imported()
    assert is_quick(module)
    assert (module.VALUE, module.__name__, module.__package__) == (1, "quick.a", "quick")
    assert (module.__file__, module.__cached__) == (str(package / "a.py"), compiled)
    assert module.__loader__.get_source("quick.a") == SOURCE  # type: ignore[union-attr]


def test_a_package_is_imported_quickly_with_its_modules_and_its_data(package: Path) -> None:
    inner = package / "inner"
    inner.mkdir()
    for name, text in (("__init__", "FACE = 2\n"), ("b", SOURCE)):
        (inner / f"{name}.py").write_text(text)
        py_compile.compile(str(inner / f"{name}.py"), doraise=True)
    (inner / "table.txt").write_text("kept")
    importlib.invalidate_caches()
    face, module = importlib.import_module("quick.inner"), importlib.import_module("quick.inner.b")
    assert is_quick(face)
    assert is_quick(module)
    assert (face.FACE, face.__package__, face.__path__, module.VALUE) == (2, "quick.inner", [str(inner)], 1)
    assert resources.files("quick.inner").joinpath("table.txt").read_text() == "kept"


def test_a_module_that_is_not_compiled_is_imported_as_usual(package: Path) -> None:
    assert imported().VALUE == 1
    assert not is_quick(imported()) or sys.dont_write_bytecode is False


def test_a_source_that_changed_after_it_was_compiled_is_compiled_again(package: Path) -> None:
    py_compile.compile(str(package / "a.py"), doraise=True)
    (package / "a.py").write_text("VALUE = 22\n")
    assert imported().VALUE == 22
    (package / "a.py").write_text("VALUE = 33\n")
    os.utime(package / "a.py", (1, 1))
    assert imported().VALUE == 33


@pytest.mark.parametrize("content", [b"", b"\0" * 16, b"\0" * 400])
def test_a_broken_compiled_file_is_not_used(package: Path, content: bytes) -> None:
    compiled = py_compile.compile(str(package / "a.py"), doraise=True)
    assert compiled is not None
    Path(compiled).write_bytes(content)
    assert imported().VALUE == 1


def test_a_compiled_file_that_is_checked_by_its_hash_is_left_to_python(package: Path) -> None:
    py_compile.compile(
        str(package / "a.py"), doraise=True, invalidation_mode=py_compile.PycInvalidationMode.CHECKED_HASH
    )
    module = imported()
    assert module.VALUE == 1
    assert not is_quick(module)


def test_nothing_changes_where_compiled_files_are_elsewhere(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(sys, "meta_path", [*sys.meta_path])
    monkeypatch.setattr(sys, "pycache_prefix", str(tmp_path))
    before = list(sys.meta_path)
    quick_imports.import_quickly()
    assert sys.meta_path == before
