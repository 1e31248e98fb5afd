"""Whatever stands in a stranger's file, each reader gives a result or says what is wrong, and soon."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

import pytest
from generating import command
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sampling import examples
from work import assert_linear

from urdfctl.cli.generate_again import words_of_generated_file
from urdfctl.config.file import config_of
from urdfctl.errors import UserError
from urdfctl.generate.joint_list import joints_listed
from urdfctl.logs.digest import digest
from urdfctl.logs.reading import Lines
from urdfctl.report.baseline import read_baseline
from urdfctl.source.gitignore import GitIgnore
from urdfctl.source.install_maps import read_install_map
from urdfctl.source.launch.frontend import of_xml, of_yaml
from urdfctl.source.launch.python import Surroundings, read_python
from urdfctl.source.packages import package_name
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.suppressions import suppressions
from urdfctl.source.xml import parse
from urdfctl.source.yaml import read_yaml


def read_launch_in_xml(data: bytes, _: Path) -> None:
    of_xml(parse(SourceText("/a.launch.xml", data)).documentElement)


def read_launch_in_yaml(data: bytes, _: Path) -> None:
    of_yaml(read_yaml(SourceText("/a.launch.yaml", data)))


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
    name.removeprefix("read_"): reader for name, reader in sorted(globals().items()) if name.startswith("read_launch_")
} | {
    reader.__name__.removeprefix("read_"): reader
    for reader in (
        *(read_comments, read_manifest, read_cmake, read_setup, read_settings, read_joints, read_known_findings),
        *(read_gitignore, read_log, read_origin),
    )
}
WORDS = [
    *["<launch>", "</launch>", "<node ", "/>", "<a b='", "<!--", "-->", "<![CDATA[", "<!DOCTYPE a [", "&a;", "&#0;"],
    *[
        "launch:",
        "- ",
        ": ",
        "\n",
        "\n  ",
        "{",
        "}",
        "[",
        "]",
        "&a ",
        "*a",
        "<<: *a",
        "!!x ",
        "|",
        "? ",
        "---\n",
        "'",
        '"',
    ],
    *[
        "$(var x)",
        "$(eval ",
        "$(find x)",
        "${",
        ")",
        "(",
        "#",
        "#[[",
        "=",
        ",",
        ".",
        "\\",
        "/",
        "**",
        "!",
        "\0",
        "\x1b[",
        "\u2028",
    ],
    *[
        "def generate_launch_description():\n",
        " return ",
        "LaunchDescription([",
        "Node(",
        "lambda x: ",
        "f'{",
        " for x in ",
    ],
    *[
        "<name>",
        "</name>",
        "install(DIRECTORY ",
        " DESTINATION ",
        "project(",
        "setup(data_files=[",
        "('share/arm', ",
        "glob(",
    ],
    *[
        "[tool.urdfctl]\n",
        "select = ",
        "[per-file-ignores]",
        "name,lower\n",
        "2001-99-99",
        "nan",
        "1e999",
        "name: ",
        "joints:",
    ],
    *[
        '{"version": 1, "findings": [',
        '"code": ',
        "[ERROR] ",
        "made by urdfctl gen-all ",
        "urdfctl: ignore UC1",
        "elbow",
    ],
]
TEXTS = st.lists(st.sampled_from(WORDS) | st.text(max_size=5), max_size=25).map(
    lambda words: "".join(words).encode("utf-8", "surrogatepass")
)


@pytest.mark.parametrize("name", READERS)
def test_no_text_is_too_odd_to_be_read_or_refused(name: str, tmp_path: Path) -> None:
    @settings(max_examples=examples(40), database=None, suppress_health_check=list(HealthCheck))
    @given(TEXTS | st.binary(max_size=60))
    def tried(data: bytes) -> None:
        with suppress(UserError, ReadError):
            READERS[name](data, tmp_path)

    tried()


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


@pytest.mark.parametrize(("name", "piece"), [case[:2] for case in REPEATED])
def test_what_is_repeated_takes_work_in_proportion_to_its_length(name: str, piece: str, tmp_path: Path) -> None:
    def read(times: int) -> None:
        with suppress(UserError, ReadError):
            READERS[name]((piece * times).encode(), tmp_path)

    assert_linear(read, 75)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[" * 9000, "j.yaml: the YAML file is nested more than 64 deep"),
        ("- 2001-99-99\n", "j.yaml: not valid YAML: month must be in 1..12"),
        ("x" * 140_000, r"j.csv: not valid CSV: field larger than field limit \(131072\)"),
    ],
)
def test_a_list_of_joints_that_cannot_be_held_is_refused(text: str, message: str) -> None:
    with pytest.raises(UserError, match=message):
        joints_listed(text, message.partition(":")[0])


def test_settings_with_keys_of_endless_parts_are_refused(tmp_path: Path) -> None:
    (tmp_path / "urdfctl.toml").write_text("a." * 9000)
    with pytest.raises(UserError, match="invalid TOML: a line with more than 4000 dots"):
        config_of(str(tmp_path / "urdfctl.toml"))


def test_settings_with_a_number_of_endless_digits_are_refused(tmp_path: Path) -> None:
    (tmp_path / "urdfctl.toml").write_text(f"a = {'9' * 5000}")
    with pytest.raises(UserError, match="invalid TOML: Exceeds the limit"):
        config_of(str(tmp_path / "urdfctl.toml"))


def test_a_list_of_joints_without_end_is_refused() -> None:
    ran = command("gen-controllers", "-", "--type", "effort", "--distro", "noetic", text="j\n" * (9 << 20))
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: standard input cannot be read: it is larger than 16 MiB\n")


@pytest.mark.skipif(os.name != "posix", reason="pipes are made as POSIX makes them")
def test_a_pipe_in_the_place_of_a_generated_file_was_made_by_nothing(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "c.yaml")
    assert words_of_generated_file(str(tmp_path / "c.yaml")) is None
