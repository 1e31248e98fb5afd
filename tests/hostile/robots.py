"""Robots that a stranger may put into a pull request: the code of the error that each must get, and its files."""

from __future__ import annotations

from collections.abc import Mapping

from sampling import WHOLE

XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
HIDDEN = "what nobody may read"


def macro(name: str, body: str, params: str = "") -> str:
    return f'<xacro:macro name="{name}" params="{params}">{body}</xacro:macro>'


DOUBLING = "".join(macro(f"m{n}", f"<xacro:m{n + 1}/><xacro:m{n + 1}/>") for n in range(30))
NINES = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 9))

TRIED: Mapping[str, tuple[str, dict[str, str]]] = {
    "entities that swell a billionfold": (
        "UC005",
        {"r.urdf": f'<!DOCTYPE r [<!ENTITY l0 "lol">{NINES}]><robot>&l8;</robot>'},
    ),
    "an entity that brings another file": (
        "UC005",
        {"r.urdf": '<!DOCTYPE r [<!ENTITY x SYSTEM "../secret">]><robot>&x;</robot>'},
    ),
    "a parameter entity from elsewhere": (
        "UC005",
        {"r.urdf": '<!DOCTYPE r [<!ENTITY % x SYSTEM "file:///etc/passwd"> %x;]><robot/>'},
    ),
    "elements a hundred thousand deep": (
        "UC014",
        {"r.urdf": "<robot name='r'>" + "<a>" * 100_000 + "</a>" * 100_000 + "</robot>"},
    ),
    "twenty megabytes of XML": ("UC014", {"r.urdf": "<robot name='r'>" + '<link name="a"/>' * 1_310_720 + "</robot>"}),
    "very many elements": (
        "UC104",
        {"r.urdf": f"<robot name='r'>{'<a/>' * (1_000_001 if WHOLE else 50_000)}</robot>"},
    ),
    "a start tag without end": ("UC001", {"r.urdf": "<robot name='r' " + "a='b' " * 100_000}),
    "nothing but beginnings": ("UC001", {"r.urdf": "<" * 1_000_000}),
    "zeros": ("UC001", {"r.urdf": "\0" * 1_000_000}),
    "a macro that calls itself": ("UC014", {"r.xacro": XACRO.format(macro("m", "<xacro:m/>") + "<xacro:m/>")}),
    "macros that call each other for ever": (
        "UC014",
        {"r.xacro": XACRO.format(macro("a", "<xacro:b/>") + macro("b", "<xacro:a/>") + "<xacro:a/>")},
    ),
    "macros whose calls double thirty times": (
        "UC014",
        {"r.xacro": XACRO.format(DOUBLING + macro("m30", "") + "<xacro:m0/>")},
    ),
    "a file that includes itself": ("UC014", {"r.xacro": XACRO.format('<xacro:include filename="r.xacro"/>')}),
    "files that include each other": (
        "UC014",
        {
            "r.xacro": XACRO.format('<xacro:include filename="s.xacro"/>'),
            "s.xacro": XACRO.format('<xacro:include filename="r.xacro"/>'),
        },
    ),
    "an include from the folder above": ("UC016", {"r.xacro": XACRO.format('<xacro:include filename="../secret"/>')}),
    "an include from the root": ("UC016", {"r.xacro": XACRO.format('<xacro:include filename="/etc/passwd"/>')}),
    "an include of a device": ("UC016", {"r.xacro": XACRO.format('<xacro:include filename="/dev/zero"/>')}),
    "an include through a link to elsewhere": (
        "UC016",
        {"r.xacro": XACRO.format('<xacro:include filename="out/secret"/>')},
    ),
    "YAML from the folder above": (
        "UC016",
        {"r.xacro": XACRO.format("<link name=\"${xacro.load_yaml('../secret')}\"/>")},
    ),
    "YAML whose aliases swell": (
        "UC014",
        {
            "r.xacro": XACRO.format("<link name=\"${xacro.load_yaml('b.yaml')}\"/>"),
            "b.yaml": "a0: &a0 [x, x]\n" + "".join(f"a{n}: &a{n} [*a{n - 1}, *a{n - 1}]\n" for n in range(1, 40)),
        },
    ),
    "YAML nested thirty thousand deep": (
        "UC014",
        {"r.xacro": XACRO.format("<link name=\"${xacro.load_yaml('b.yaml')}\"/>"), "b.yaml": "[" * 30_000},
    ),
    "a power without end": ("UC015", {"r.xacro": XACRO.format('<link name="${9**9**9}"/>')}),
    "a text repeated without end": ("UC015", {"r.xacro": XACRO.format("<link name=\"${'a' * 10**12}\"/>")}),
    "a range without end": ("UC015", {"r.xacro": XACRO.format('<link name="${len([x for x in range(10**12)])}"/>')}),
    "code in an expression": ("UC015", {"r.xacro": XACRO.format('<link name="${().__class__.__base__}"/>')}),
    "code in an eval": (
        "UC015",
        {"r.xacro": XACRO.format("<link name='$(eval [].append.im_self)'/>")},
    ),
    "code in the default of an argument": (
        "UC015",
        {"r.xacro": XACRO.format('<xacro:arg name="x" default="$(eval [].append.im_self)"/><link name="$(arg x)"/>')},
    ),
    "code by way of import": (
        "UC010",
        {"r.xacro": XACRO.format("<link name=\"$(eval __import__('os').system('touch ../ran'))\"/>")},
    ),
}
