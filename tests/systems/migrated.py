"""Systems of Gazebo Classic, migrated to gz: what is wrong about what the migrated launch files start."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from folder import Folder
from simulated_start import faults, spawned
from started import NotStarted, started

from systems.draw import draw
from systems.idioms import drawn, settled
from systems.possible import Idioms
from systems.render import Workspace, render
from systems.system import CLASSIC, System
from urdfctl import api
from urdfctl.diagnostic import Severity

_TARGET = "jazzy"
_ADDRESS = "robot_ip:=10.0.0.1"
"""The argument that a person must give where no document gives it."""
Started = list[dict[str, Any]]


class Migrated(NamedTuple):
    """A system that was migrated. wrong: what keeps it from starting as before, each as a sentence."""

    seed: int
    idioms: Idioms
    wrong: tuple[str, ...]


def is_migrated(seed: int, wanted: Idioms | None = None) -> bool:
    """Return whether the system of a seed is one of Gazebo Classic, with a description that is there, and can be
    written in wanted idioms, if any are."""
    system = draw(seed, is_faulty=False)
    idioms = _idioms(system, wanted)
    is_wanted = all(idioms[name] == position for name, position in (wanted or {}).items())
    return system.simulator == CLASSIC and idioms["source"] != "built" and is_wanted


def migrated(seed: int, wanted: Idioms | None = None) -> Migrated:
    """Migrate the system of a seed, without an inconsistency and with nothing beside it, and judge the result.

    wanted: the idioms to write it in, with all other switches plain; those of the seed if None.
    """
    system = draw(seed, is_faulty=False)
    workspace = render(system, {**_idioms(system, wanted), "distractor": "none"})
    with TemporaryDirectory(prefix="urdfctl-migrated-") as name:
        folder = Path(name).resolve() / "src"
        workspace.write(folder)
        return Migrated(seed, workspace.idioms, tuple(_wrong(workspace, folder)))


def _idioms(system: System, wanted: Idioms | None) -> Idioms:
    return drawn(system) if wanted is None else settled(system, wanted)


def _wrong(workspace: Workspace, folder: Path) -> Iterator[str]:
    words = ("migrate", ".", "--from", workspace.system.distro, "--to", _TARGET, "--simulator", "gz")
    ran = Folder(folder).run(*words, "--in-place", "--force")
    if ran.returncode:
        yield f"the migration ends with {ran.returncode}: {ran.stderr.strip()}"
        return
    yield from _of_starts(workspace, folder)
    yield from _of_lint(folder)
    again = Folder(folder).run(*words)
    if again.returncode:
        yield f"a second migration changes something: {again.stdout.strip()}"


def _of_starts(workspace: Workspace, folder: Path) -> Iterator[str]:
    """What keeps the launch files from starting what those before them started.

    Files in XML and YAML, and Python with parts in these, cannot be run here: lint alone reads them.
    """
    found: list[Started] = []
    for start in workspace.starts:
        path = folder / (start if start.endswith(".py") else f"{start}.py")
        if not path.is_file():
            if workspace.system.generation == 1:
                yield f"{start} has no successor"
            return
        try:
            found.append(started(path, folder, _ADDRESS, *_documented(workspace)))
        except NotStarted as error:
            if "No module named 'launch_" not in str(error):
                yield f"{path.name} raises {str(error).splitlines()[-1]}"
            return
    is_split = workspace.idioms["split"] != "one start"
    for one in [[each for part in found for each in part]] if is_split else found:
        yield from faults(one)
    wanted = {f"/{name.strip('/')}" for robot in workspace.robots for name in robot.spawned}
    names = set().union(*map(spawned, found))
    if names != wanted:
        yield f"spawned are {sorted(names)}, before {sorted(wanted)}"


def _documented(workspace: Workspace) -> list[str]:
    """The arguments that documents and scripts start launch files with."""
    texts = (text for path, text in workspace.files.items() if path.endswith((".md", ".rst", ".txt", ".sh", ".bash")))
    return [word for text in texts for word in re.findall(r"\b\w+:=[^\s`]+", text)]


def _of_lint(folder: Path) -> Iterator[str]:
    for finding in api.lint(folder, workspace=folder, jobs=1, distro=_TARGET).findings:
        if finding.severity is Severity.ERROR:
            yield f"lint tells {finding.code}: {finding.message}"
