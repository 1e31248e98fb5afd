"""Load a model in MuJoCo before it is written, in a worker, and leave out the meshes that it does not load."""

from __future__ import annotations

import os
import re
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.generate.options import File
from urdfctl.run.limits import Limits
from urdfctl.run.pool import run_jobs
from urdfctl.startup.records import NamedTuple

_FILE = re.compile(r'(<mesh name="([^"]*)" file=")([^"]*)(")')
_MESH = re.compile(r'<mesh name="([^"]*)"')
_MOST_MESHES = 20
"""After so many meshes that do not load, the model is given up."""


class CheckedModel(NamedTuple):
    """A model that MuJoCo loads.

    left_out: the meshes that it does not load, each with the reason.
    fault: why it does not load without them; empty if it does, or if MuJoCo is not installed.
    """

    file: File
    left_out: tuple[str, ...] = ()
    fault: str = ""


def loaded_model(file: File, output: str | None, settings: Settings) -> CheckedModel:
    """Return a model without the meshes that MuJoCo refuses. output: the file that it will be written to."""
    text, left_out = file.text, list[str]()
    folder = os.path.dirname(os.path.abspath(output or file.name))
    for _ in range(_MOST_MESHES):
        absolute = _FILE.sub(lambda found: f"{found[1]}{os.path.join(folder, found[3])}{found[4]}", text)
        limits = Limits(settings.timeout, settings.memory, settings.environ)
        job = {"text": absolute}
        [result] = run_jobs([job], load_job, limits, 1, function_name="urdfctl.commands.generate.model_check:load_job")
        fault = result["fault"] if isinstance(result, dict) else f"MuJoCo crashes: {result.reason}"
        if not fault:
            break
        name = _mesh_named(fault, text)
        if name is None:
            return CheckedModel(File(file.name, text), tuple(left_out), fault)
        left_out.append(f"mesh '{name}' is left out, because MuJoCo does not load it: {fault}")
        text = without_mesh(text, name)
    return CheckedModel(File(file.name, text), tuple(left_out))


def load_job(job: dict[str, Any]) -> dict[str, Any]:
    """Return why a model does not load, in a worker."""
    from urdfctl.smoke.engines import is_checkable, mjcf_fault

    return {"fault": mjcf_fault(job["text"]) if is_checkable() else ""}


def _mesh_named(fault: str, text: str) -> str | None:
    """The mesh that a message of MuJoCo names, by its name or its file."""
    meshes = [(found[2], found[3]) for found in _FILE.finditer(text)]
    known = [name for name, path in meshes if os.path.basename(path) in fault]
    known += [found[1] for found in _MESH.finditer(text) if f"'{found[1]}'" in fault]
    return next(iter(known), None)


def without_mesh(text: str, name: str) -> str:
    """Return a model without a mesh and what has its shape."""
    lines = text.split("\n")
    asset, shape = f'<mesh name="{name}" ', f'mesh="{name}"'
    return "\n".join(line for line in lines if asset not in line and not ("<geom " in line and shape in line))
