"""The kind ``sphere-fluid``: an ideal fluid on a sphere, with its start, answers and maps."""
