"""The answers to an editor's questions: completion, hover, navigation, symbols, quick fixes."""
