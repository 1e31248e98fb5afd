"""The readers of texts that strangers write, each as one function of bytes and a folder; what they read badly.

Adding a reader is a function here: the tests, and the fuzzers of tests/fuzz, then try it.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from urdfctl.config.file import config_of
from urdfctl.errors import UserError
from urdfctl.generate.files.again import words_of_generated_file
from urdfctl.generate.request.joint_list import joints_listed
from urdfctl.logs.digest import digest
from urdfctl.logs.reading import Lines
from urdfctl.model.launch.ros2.forms import malformed
from urdfctl.report.baseline import read_baseline
from urdfctl.source.disk.gitignore import GitIgnore
from urdfctl.source.launch.frontend import Entity, description, of_xml, of_yaml
from urdfctl.source.launch.python import Surroundings, read_python
from urdfctl.source.span import SourceText
from urdfctl.source.suppressions import suppressions
from urdfctl.source.workspaces.install_maps import read_install_map
from urdfctl.source.workspaces.packages import package_name
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import read_yaml


def read_launch_in_xml(data: bytes, _: Path) -> None:
    _use(of_xml(parse(SourceText("/a.launch.xml", data)).documentElement))


def read_launch_in_yaml(data: bytes, _: Path) -> None:
    if root := of_yaml(read_yaml(SourceText("/a.launch.yaml", data))):
        _use(root)


def _use(root: Entity) -> None:
    description(root)
    list(malformed(root))


def read_launch_in_python(data: bytes, _: Path) -> None:
    read_python(SourceText("/a.launch.py", data), Surroundings(lambda *_: None, {}))


def read_comments(data: bytes, _: Path) -> None:
    suppressions(SourceText("/a.urdf", data))
    suppressions(SourceText("/a.yaml", data))


def read_manifest(data: bytes, folder: Path) -> None:
    (folder / "package.xml").write_bytes(data)
    package_name(str(folder / "package.xml"))


def read_cmake(data: bytes, folder: Path) -> None:
    (folder / "CMakeLists.txt").write_bytes(data)
    read_install_map(str(folder), "arm").source_of("urdf/a.xacro")
    (folder / "CMakeLists.txt").unlink()


def read_setup(data: bytes, folder: Path) -> None:
    (folder / "setup.py").write_bytes(data + b"\n# data_files")
    read_install_map(str(folder), "arm").source_of("urdf/a.xacro")
    (folder / "setup.py").unlink()


def read_settings(data: bytes, folder: Path) -> None:
    for name in ("urdfctl.toml", "pyproject.toml"):
        (folder / name).write_bytes(data)
        with suppress(UserError):
            config_of(str(folder / name))


def read_joints(data: bytes, _: Path) -> None:
    for name in ("joints.txt", "joints.csv", "joints.yaml"):
        with suppress(UserError):
            joints_listed(data.decode("utf-8", "replace"), name)


def read_known_findings(data: bytes, folder: Path) -> None:
    (folder / "known.json").write_bytes(data)
    read_baseline(str(folder / "known.json"))


def read_gitignore(data: bytes, folder: Path) -> None:
    (folder / ".git").mkdir(exist_ok=True)
    (folder / ".gitignore").write_bytes(data)
    GitIgnore(str(folder)).ignores(str(folder / ("a" * 200)), is_folder=False)


def read_log(data: bytes, _: Path) -> None:
    digest(Lines(io.BytesIO(data)), pasted=False)


def read_origin(data: bytes, folder: Path) -> None:
    (folder / "made.yaml").write_bytes(data)
    words_of_generated_file(str(folder / "made.yaml"))


READERS: Mapping[str, Callable[[bytes, Path], None]] = {
    "launch_in_xml": read_launch_in_xml,
    "launch_in_yaml": read_launch_in_yaml,
    "launch_in_python": read_launch_in_python,
    "comments": read_comments,
    "manifest": read_manifest,
    "cmake": read_cmake,
    "setup": read_setup,
    "settings": read_settings,
    "joints": read_joints,
    "known_findings": read_known_findings,
    "gitignore": read_gitignore,
    "log": read_log,
    "origin": read_origin,
}
WORDS = [
    "<launch>", "</launch>", "<node ", "/>", "<a b='", "<!--", "-->", "<![CDATA[", "<!DOCTYPE a [", "&a;", "&#0;",
    "launch:", "- ", ": ", "\n", "\n  ", "{", "}", "[", "]", "&a ", "*a", "<<: *a", "!!x ", "|", "? ", "---\n", "'",
    '"', "$(var x)", "$(eval ", "$(find x)", "${", ")", "(", "#", "#[[", "=", ",", ".", "\\", "/", "**", "!", "\x00",
    "\x1b[", "\u2028", "def generate_launch_description():\n", " return ", "LaunchDescription([", "Node(",
    "lambda x: ", "f'{", " for x in ", "<name>", "</name>", "install(DIRECTORY ", " DESTINATION ", "project(",
    "setup(data_files=[", "('share/arm', ", "glob(", "[tool.urdfctl]\n", "select = ", "[per-file-ignores]",
    "name,lower\n", "2001-99-99", "nan", "1e999", "name: ", "joints:", '{"version": 1, "findings": [', '"code": ',
    "[ERROR] ", "made by urdfctl gen-all ", "urdfctl: ignore UC1", "elbow",
]  # fmt: skip
"""Words of all that is read, which a text is made of at random."""

REPEATED = [
    ("cmake", "install(", 1 << 20),
    ("cmake", "install(DIRECTORY ", 1 << 20),
    ("setup", "not ", 1 << 16),
    ("setup", "[", 1 << 16),
    ("settings", "\n", 1 << 20),
    ("settings", " ", 1 << 20),
    ("settings", "a.", 1 << 20),
    ("joints", "[", 1 << 18),
    ("joints", "- ", 1 << 18),
    ("joints", "? ", 1 << 16),
    ("manifest", "<name", 1 << 16),
    ("launch_in_yaml", "- ", 1 << 16),
    ("launch_in_python", "-", 1 << 16),
]
"""Readers, pieces of text, and a size in bytes at which work that grows with its square would take minutes."""
