"""Bodies of generate_launch_description() in Python that never end, or take more memory than there is."""

from __future__ import annotations

ENDLESS = {
    "deep": "x = " + "(" * 150 + "1" + ")" * 150,
    "doubling": "x = 'a'\nfor _ in [1, 2, 3, 4, 5, 6, 7, 8, 9] * 1:\n    x = x + x\n" + "x = x + x\n" * 60,
    "lists": "x = [1]\n" + "x = x + x\n" * 60,
    "loops": "\n".join("    " * i + f"for i{i} in {list(range(100))}:" for i in range(8)) + "\n" + " " * 32 + "x = 1",
    "recursion": "def f(x):\n    return f(x)\nf(1)",
    "two ways again": "\n".join("if a():\n    x = x() or [1]" for _ in range(200)),
    "itself": "x = []\nx.append(x)\nx.extend(x)\nld = LaunchDescription(x)",
}
