"""The generated files: descriptions, controllers.yaml, launch files, MuJoCo, MoveIt; and how they are written."""
