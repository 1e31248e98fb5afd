"""What an editor is told while the user types is what `urdfctl lint` finds in the same texts."""

from __future__ import annotations

import json
import random
import shutil
from pathlib import Path

import pytest
from editor import Editor, in_editor
from edits import edited
from folder import CHECKOUT, Folder
from live_replay import copied, differences

SAMPLES = CHECKOUT / "samples"


def test_after_random_edits_only_what_changed_is_linted_again_and_nothing_is_missed(tmp_path: Path) -> None:
    """The exhaustive form is tests/bench/exhaustive/test_live.py."""
    assert list(differences(copied(SAMPLES, tmp_path), edits=24, seed=11, every=6)) == []


@pytest.mark.parametrize("seed", range(2))
def test_the_server_sends_what_lint_finds(folder: Folder, seed: int) -> None:
    rng = random.Random(seed)  # noqa: S311
    workspace = copied(SAMPLES / "broken", folder.path)
    names = sorted(str(path.relative_to(workspace)) for path in workspace.rglob("*.xacro"))

    async def use(editor: Editor) -> dict[str, list[tuple[str, int, int]]]:
        for name in names:
            await editor.open(name)
        for name in rng.choices(names, k=6):
            text = edited((workspace / name).read_text(encoding="utf-8"), rng)
            await editor.type(name, text)
            (workspace / name).write_text(text, encoding="utf-8")
        return await editor.checked()

    told = in_editor(workspace, use, ["utf-32"])
    ran = folder.run("lint", ".", "--format", "json", "--exit-zero", "--no-cache", cwd=workspace)
    found: dict[str, list[tuple[str, int, int]]] = {}
    for finding in json.loads(ran.stdout)["findings"]:
        for place in (finding, *finding["also"]):
            at = place if "line" in place else place["at"]
            found.setdefault(at["file"], []).append((finding["code"], at["line"] - 1, at["column"] - 1))
    assert {file: sorted(codes) for file, codes in told.items()} == {f: sorted(codes) for f, codes in found.items()}
    shutil.rmtree(workspace)
