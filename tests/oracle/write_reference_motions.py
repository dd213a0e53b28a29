"""Write ``polhode/judging/reference_motions.json`` anew: ``cd tests && python -m oracle.write_reference_motions``.

Takes some minutes. Raise ``VERSION`` in ``reference_table.py`` whenever a number or a name in the table changes.
"""

from oracle.reference_table import TABLE, hard_motions, table_text

if __name__ == "__main__":
    TABLE.write_text(table_text(hard_motions()), encoding="utf-8")
    print(f"{TABLE}: {TABLE.stat().st_size} bytes")
