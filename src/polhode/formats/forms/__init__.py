"""The file formats: one module each with its ``FORM``; none needs to be registered.

Its line in ``polhode/plugin.toml`` says how its files are recognised, so that it is imported only to be used.

Another package adds one by the entry-point group ``polhode.formats``.
"""
