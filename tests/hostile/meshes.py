"""Meshes that are none, or too much: the kind, and the bytes."""

from __future__ import annotations

import struct

ZEROS = bytes(80)
NAN = struct.pack("<12f2x", *[float("nan")] * 12)
FAR = struct.pack("<12f2x", *[3.4e38] * 12)
COLLADA = '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">{}</COLLADA>'
SCENE = """<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0
</float_array><technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_nodes>{}<node id="last"><instance_geometry url="#g"/></node></library_nodes>
<library_visual_scenes><visual_scene id="s">{}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>"""
TWICE = '<node id="n{}"><instance_node url="#{}"/><instance_node url="#{}"/></node>'
NAMES = ["last", *(f"n{n}" for n in range(40))]
DOUBLING = "".join(TWICE.format(n, NAMES[n], NAMES[n]) for n in range(40))

MESHES: dict[str, tuple[str, bytes]] = {
    "nothing": ("stl", b""),
    "a count of four thousand million": ("stl", ZEROS + struct.pack("<I", 0xFFFFFFFF)),
    "a count that is one too large": ("stl", ZEROS + struct.pack("<I", 2) + bytes(50)),
    "corners that are no numbers": ("stl", ZEROS + struct.pack("<I", 1) + NAN),
    "corners at the end of the world": ("stl", ZEROS + struct.pack("<I", 1) + FAR),
    "text that begins and does not end": ("stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0"),
    "text with words for numbers": ("stl", b"solid x\nfacet normal a b c\nouter loop\n" + b"vertex x y z\n" * 3),
    "text without end": ("stl", b"solid " + b"facet " * 100_000),
    "a pointer of Git LFS": ("stl", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n"),
    "faces that name no corner": ("obj", b"v 0 0 0\nf 1 2 3\nf 9999999999 -5 0\n"),
    "faces of a million corners": ("obj", b"v 0 0 0\nf " + b"1 " * 200_000),
    "a material from outside": (
        "obj",
        b"mtllib ../secret.mtl\nmtllib /etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    ),
    "only a beginning": ("obj", b"v " * 100_000),
    "no XML": ("dae", b"<COLLADA"),
    "entities that swell": (
        "dae",
        b'<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">'
        + b"".join(b'<!ENTITY a%d "%s">' % (n, b"&a%d;" % (n - 1) * 10 if n else b"&a;" * 10) for n in range(9))
        + b"]><COLLADA>&a8;</COLLADA>",
    ),
    "an entity from outside": ("dae", b'<!DOCTYPE a [<!ENTITY a SYSTEM "../secret">]><COLLADA>&a;</COLLADA>'),
    "nodes in nodes": ("dae", COLLADA.format(SCENE.format("", "<node>" * 5000 + "</node>" * 5000)).encode()),
    "a node that contains itself": (
        "dae",
        COLLADA.format(SCENE.format(TWICE.format(1, "n1", "n1"), '<node><instance_node url="#n1"/></node>')).encode(),
    ),
    "nodes that double": (
        "dae",
        COLLADA.format(SCENE.format(DOUBLING, '<node><instance_node url="#n39"/></node>')).encode(),
    ),
    "a unit that is no number": ("dae", COLLADA.format('<asset><unit meter="nan"/></asset>').encode()),
    "a stride of nothing": ("dae", COLLADA.format('<accessor stride="0"/><accessor stride="-9"/>').encode()),
}
