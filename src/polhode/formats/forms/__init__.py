"""The file formats: one module each with its ``FORM``, which is found without being registered.

Another package adds one by the entry-point group ``polhode.formats``.
"""
