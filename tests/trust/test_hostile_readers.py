"""Whatever stands in a stranger's file, each reader gives a result or says what is wrong, and soon."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

import pytest
from generating import command
from hostile.joints import REFUSED_JOINTS
from hostile.readers import READERS, REPEATED, WORDS
from hostile.settings import REFUSED_SETTINGS
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from sampling import examples
from work import assert_linear

from urdfctl.config.file import config_of
from urdfctl.errors import UserError
from urdfctl.generate.files.again import words_of_generated_file
from urdfctl.generate.request.joint_list import joints_listed
from urdfctl.source.problem import ReadError

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


@pytest.mark.parametrize(("name", "piece"), [case[:2] for case in REPEATED])
def test_what_is_repeated_takes_work_in_proportion_to_its_length(name: str, piece: str, tmp_path: Path) -> None:
    def read(times: int) -> None:
        with suppress(UserError, ReadError):
            READERS[name]((piece * times).encode(), tmp_path)

    assert_linear(read, 75)


@pytest.mark.parametrize(("text", "message"), REFUSED_JOINTS)
def test_a_list_of_joints_that_cannot_be_held_is_refused(text: str, message: str) -> None:
    with pytest.raises(UserError, match=message):
        joints_listed(text, message.partition(":")[0])


@pytest.mark.parametrize("name", REFUSED_SETTINGS)
def test_settings_that_cannot_be_read_are_refused(name: str, tmp_path: Path) -> None:
    text, message = REFUSED_SETTINGS[name]
    (tmp_path / "urdfctl.toml").write_text(text)
    with pytest.raises(UserError, match=message):
        config_of(str(tmp_path / "urdfctl.toml"))


def test_a_list_of_joints_without_end_is_refused() -> None:
    ran = command("gen-controllers", "-", "--type", "effort", "--distro", "noetic", text="j\n" * (9 << 20))
    assert (ran.returncode, ran.stderr) == (2, "urdfctl: standard input cannot be read: it is larger than 16 MiB\n")


@pytest.mark.skipif(os.name != "posix", reason="pipes are made as POSIX makes them")
def test_a_pipe_in_the_place_of_a_generated_file_was_made_by_nothing(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "c.yaml")
    assert words_of_generated_file(str(tmp_path / "c.yaml")) is None
