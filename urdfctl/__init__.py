"""urdfctl: lints, generates and smoke-tests the control configuration of robots described in URDF and xacro."""

__version__ = "0.1.0"

SITE = "https://urdfctl.github.io/urdfctl/"
"""The documentation, with a slash at its end: findings, reports and the site itself name it."""
REPOSITORY = "https://github.com/urdfctl/urdfctl"
"""The source."""
