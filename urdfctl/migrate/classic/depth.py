"""The range of a camera with depth, which gz reads from the camera instead of from its plugin."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import appended, child, content, indent_of, indented, step_of
from urdfctl.source.xml.dom import Element

_NEAR = ("min_depth", "pointCloudCutoff")
_FAR = ("max_depth", "pointCloudCutoffMax")
DEPTH_RANGE = (*_NEAR, *_FAR)
"""The settings of Gazebo Classic's plugins for the range, in m, in the spelling of ROS 2 and of ROS 1."""


def depth_range(sensor: Element, plugin: Element) -> Sequence[Edit]:
    """Return the edit that writes the range of a plugin in the `<camera>` of its sensor; none if there is nowhere to.

    gz-sensors src/RgbdCameraSensor.cc, CreateCameras(): `<depth_camera><clip>` limits only the image of the depths.
    """
    camera = child(sensor, "camera")
    lines = []
    for name, old in (("near", _NEAR), ("far", _FAR)):
        setting = next((one for one in (child(plugin, each) for each in old) if one is not None), None)
        if setting is not None and content(setting):
            lines.append(f"<{name}>{content(setting)}</{name}>\n")
    if camera is None or camera.close is None or child(camera, "depth_camera") is not None or not lines:
        return ()
    step = step_of(sensor.source)
    clip = f"<clip>\n{indented(''.join(lines), step)}</clip>\n"
    text = f"<depth_camera>\n{indented(clip, step)}</depth_camera>\n"
    return (appended(camera, indented(text, indent_of(camera) + step).splitlines()),)
