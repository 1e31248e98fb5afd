"""Whether MuJoCo loads a model that was generated."""

from __future__ import annotations

import importlib.util

from urdfctl.smoke.engines import quick_mujoco


def is_checkable() -> bool:
    """Return whether MuJoCo is installed."""
    return importlib.util.find_spec("mujoco") is not None


def mjcf_fault(text: str) -> str:
    """Return why MuJoCo does not load a model whose meshes have absolute paths, in one line; empty if it does."""
    mujoco = quick_mujoco.load()
    mujoco.set_mju_user_warning(lambda _: None)
    try:
        mujoco.MjModel.from_xml_string(text)
    except ValueError as error:
        return " ".join(str(error).split()) or "it is not valid"
    return ""
