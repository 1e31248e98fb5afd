"""`python -m urdfctl`, and the entry point of the command."""

from __future__ import annotations


def main() -> None:
    """Run the command line."""
    from urdfctl.cli.app import run

    run()


if __name__ == "__main__":
    main()
