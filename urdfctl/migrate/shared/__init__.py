"""What several steps read and write: sections of controller files, plugins, rules of installation."""
