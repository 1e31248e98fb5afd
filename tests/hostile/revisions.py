"""Trees of git revisions that no well-meaning git writes: entries by mode, name and content."""

from __future__ import annotations

ROBOT = b'<robot name="arm"><link name="base"/></robot>\n'

TREES: dict[str, list[tuple[str, str, bytes]]] = {
    "above": [("100644", "../secret.png", b""), ("100644", "../secret.urdf", ROBOT)],
    "of-git": [("100644", ".git/config", b"[core]\n\tfsmonitor = touch ran\n"), ("100644", ".GIT/hooks/x", b"")],
    "absolute": [("100644", "/secret.stl", b""), ("100644", "/secret.urdf", ROBOT)],
    "links": [
        ("120000", "link.urdf", b"/etc/hostname"),
        ("120000", "out", b"../.."),
        ("100644", "out/secret.png", b""),
        ("120000", "secret.stl", b"../../secret"),
    ],
    "modules": [("160000", "module", b""), ("160000", "module.png", b"")],
    "names": [
        ("100644", "a\nb.urdf", ROBOT),
        ("100644", "a\tb.urdf", ROBOT),
        ("100644", '"quoted".urdf', ROBOT),
        ("100644", "\x1b[31m.urdf", ROBOT),
        ("100644", "\udcff.urdf", ROBOT),
        ("100644", "-o.urdf", ROBOT),
        ("100644", ":(top)x.urdf", ROBOT),
        ("100644", "x" * 250 + ".urdf", ROBOT),
        ("100644", " ", ROBOT),
    ],
    "twice": [("100644", "a.urdf", ROBOT), ("100644", "a.urdf", b"<robot"), ("100644", "a.urdf/b.urdf", ROBOT)],
    "modes": [("100755", "run.urdf", ROBOT), ("100000", "odd.urdf", ROBOT), ("777777", "odder.urdf", ROBOT)],
    "deep": [("100644", "a/" * 200 + "b.urdf", ROBOT)],
    "attributes": [("100644", ".gitattributes", b"* filter=x text eol=crlf ident export-ignore\n")],
    "many": [("100644", f"mesh{number}.stl", b"") for number in range(300)],
}
