"""Schemas of what controllers and hardware read: JSON Schema 2020-12 from the catalogue, and XML Schema 1.0.

`controllers.py` and `robot.py` make them, `checking.py` validates a file with jsonschema or lxml and finds the places.
"""
