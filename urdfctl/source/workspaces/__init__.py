"""Packages, their workspace, and where they install their files, without ROS."""
