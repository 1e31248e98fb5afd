"""urdfctl: lints, generates and smoke-tests the control configuration of robots described in URDF and xacro."""

__version__ = "0.1.0"
