"""Write an example of a fault to a folder, to lint it there."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfctl.config.settings import Settings
from urdfctl.fault import Example
from urdfctl.load.target import Target
from urdfctl.rules.examples import companions, options_of, unmarked


def written(example: Example, folder: str) -> tuple[Target, Settings]:
    """Write an example's files without their marks to a folder. Return what to lint there, and the settings for it."""
    files, _ = unmarked(example.files)
    write_files(files, folder)
    options, arguments = options_of(example)
    controllers, launch = companions(files)
    target = Target(
        os.path.join(folder, next(iter(files))),
        arguments,
        controllers=tuple(os.path.join(folder, name) for name in controllers),
        launch=os.path.join(folder, launch) if launch else None,
    )
    return target, Settings(workspace=folder, **options)


def write_files(files: Mapping[str, str], folder: str) -> None:
    """Write texts to a folder, by their names in it."""
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
