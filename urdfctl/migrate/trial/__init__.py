"""Apply steps to a copy of the packages, and judge what comes of it."""
