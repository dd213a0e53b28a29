"""The forms of files, a module each with its ``FORM``, which registers itself by being here.

Another package adds one by the entry-point group ``polhode.formats``.
"""
