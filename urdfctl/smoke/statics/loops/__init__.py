"""Judges the control loops: whether gains hold a joint, swing it, or shake it apart."""
