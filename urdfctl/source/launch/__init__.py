"""Launch files of ROS 2, in Python, XML and YAML, as the same terms: what they would do, without doing it."""
