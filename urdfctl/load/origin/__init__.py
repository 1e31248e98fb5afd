"""Which distro and simulator a robot is for, from what indicates it."""
