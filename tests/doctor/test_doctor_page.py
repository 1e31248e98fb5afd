"""`urdfctl doctor --report`: a page with what is wrong in a running system, what is fine, and what is really wired."""

from __future__ import annotations

import json
from collections.abc import Callable

from folder import Folder
from pages import Elements

from urdfctl.rules.running.samples import FILES, Recorded, controllers_in, sound


def page_of(folder: Folder, change: Callable[[Recorded], object]) -> Elements:
    recording = sound()
    change(recording)
    folder.write({**FILES, "snapshot.json": json.dumps(recording)})
    ran = folder.run("doctor", "snapshot.json", "--report", "page.html")
    assert ran.returncode in (0, 1), ran.stderr
    return Elements((folder.path / "page.html").read_text())


def inactive(recording: Recorded) -> None:
    controllers_in(recording)[1].update(state="inactive", claimed_interfaces=[])


def silent_about_states(recording: Recorded) -> None:
    for controller in controllers_in(recording):
        controller.pop("required_state_interfaces", None)


def test_what_is_wrong_comes_with_a_link_to_its_line_and_is_red_in_the_graph(folder: Folder) -> None:
    page = page_of(folder, inactive)
    assert {"Running system", "1 error", "error UC832", "What is really wired"} <= set(page.texts)
    assert "controllers.yaml" in page.addresses
    assert "UC832" in "".join(page.texts).partition("What is really wired")[2]


def test_a_sound_system_has_a_page_that_says_what_is_fine(folder: Folder) -> None:
    page = page_of(folder, lambda _: None)
    assert "nothing differs from launch/arm.launch.xml" in page.texts
    assert [text for text in page.texts if text.startswith("/joint_states comes at")]


def test_a_recording_that_does_not_list_what_is_read_draws_no_difference_in_it(folder: Folder) -> None:
    page = page_of(folder, silent_about_states)
    assert not [text for text in page.texts if text.startswith("UC")]
