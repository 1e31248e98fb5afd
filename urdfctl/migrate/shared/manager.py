"""The section of the controller manager in a controller file."""

from __future__ import annotations

from collections.abc import Mapping

BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"
RATE = 100
"""The update rate in Hz, if nothing in the packages says another one."""


def manager_text(namespace: str, types: Mapping[str, str], rate: int, *, simulated: bool) -> str:
    """Return the section of the controller manager of a namespace, with the types of its controllers by name."""
    name = f"{namespace.rstrip('/')}/controller_manager" if namespace.strip("/") else "controller_manager"
    lines = [f'"{name}":' if "*" in name else f"{name}:", "  ros__parameters:", f"    update_rate: {rate}  # Hz"]
    lines += ["    use_sim_time: true"] if simulated else []
    for controller, kind in types.items():
        lines += ["", f"    {controller}:", f"      type: {kind}"]
    return "\n".join(lines) + "\n"
