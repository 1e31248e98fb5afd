"""Lists of joints that cannot be read: the text, and what is said about it."""

from __future__ import annotations

REFUSED_JOINTS = [
    ("[" * 9000, "j.yaml: the YAML file is nested more than 64 deep"),
    ("- 2001-99-99\n", "j.yaml: not valid YAML: month must be in 1..12"),
    ("x" * 140_000, r"j.csv: not valid CSV: field larger than field limit \(131072\)"),
]
