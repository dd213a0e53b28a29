"""The formulas of ``polhode.exact`` in other languages: ``language`` reads them, one file for each language prints.

The formulas are straight lines of Python over single numbers, see ``tree``. They are read as they are in ``src``, with
names, docstrings and comments, so that what is printed can be read and checked beside them. ``python -m printing`` in
``reference/`` prints all files anew; ``tests/reference/test_printing.py`` compares these with a fresh print.
"""
