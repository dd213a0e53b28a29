"""Write the fixed-step cases anew, as JSON and as C: ``cd tests && python -m oracle.write_fixed_step_cases``.

Raise ``VERSION`` in ``fixed_step_cases.py`` whenever a number or a name changes.
"""

from oracle.fixed_step_cases import HEADER, TABLE, as_dict, cases, header_text, table_text

if __name__ == "__main__":
    found = [as_dict(case) for case in cases()]
    TABLE.write_text(table_text(found), encoding="utf-8")
    HEADER.write_text(header_text(found), encoding="utf-8")
    print(f"{TABLE}: {TABLE.stat().st_size} bytes, {HEADER}: {HEADER.stat().st_size} bytes")
