"""The file formats, one module each with its ``FORM``, found because it is in this folder.

Another package adds one by the entry-point group ``polhode.formats``.
"""
