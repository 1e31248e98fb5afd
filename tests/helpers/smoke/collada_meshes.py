"""Files in COLLADA with one mesh each."""

from __future__ import annotations

BOX = " ".join(f"{x} {y} {z}" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))
FACES = "0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3"
SHOWN = '<instance_geometry url="#g"/>'
"""What a node of the scene contains to show the mesh."""


def dae(node: str, points: str = BOX, meter: str = "1", more: str = "") -> str:
    """Return a file with a mesh of some corners, which a node of its scene shows."""
    count = len(points.split())
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="u" meter="{meter}"/><up_axis>Y_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="{count}">{points}</float_array>
      <technique_common><accessor source="#a" count="{count // 3}" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{FACES}</p></triangles>
  </mesh></geometry></library_geometries>
  {more}
  <library_visual_scenes><visual_scene id="s"><node id="n">{node}</node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""
