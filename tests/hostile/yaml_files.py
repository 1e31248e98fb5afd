"""YAML files that try to run code, or to take more memory than there is; MARKER is a file that running them makes."""

from __future__ import annotations

REFUSED_YAML = {
    "a call": "!!python/object/apply:os.system ['touch MARKER']",
    "a new object": "!!python/object/new:os.system ['touch MARKER']",
    "a name": "!!python/name:os.system ''",
    "a module": "!!python/module:os ''",
    "code as an angle": "a: !degrees \"__import__('os').system('touch MARKER')\"",
    "a lambda as an angle": "a: !degrees \"(lambda: ().__class__.__base__.__subclasses__())()\"",
    "a tower as a length": "a: !meters 9**9**8",
    "brackets without end": "[" * 30_000,
    "dashes without end": "- " * 30_000,
    "braces without end": "{a: " * 30_000,
    "aliases of aliases": "a: &a [" + "x, " * 9 + "x]\n" + "".join(
        f"{n}: &{n} [" + f"*{p}, " * 9 + f"*{p}]\n" for p, n in zip("abcdefgh", "bcdefghi", strict=True)
    ),
    "a long text a thousand times": "a: &a " + "x" * 100_000 + "\nb: [" + "*a, " * 1000 + "]",
}  # fmt: skip
