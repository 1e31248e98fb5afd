"""The language server: findings while the user types, and what an editor asks about a place in a file.

`workspace.py` keeps the open texts and lints them in one thread; `app.py` speaks the protocol and knows pygls. What an
editor asks for is answered by one module each, which takes and returns plain data of urdfctl: positions are converted
at the edge, in `positions.py`.
"""
