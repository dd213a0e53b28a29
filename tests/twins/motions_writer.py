"""Write ``motions.json`` anew: ``cd tests && python -m twins.motions_writer``, in half a minute.

Motions are drawn by families.py's generators from a seed, and their states come from the oracles in tests/oracle, by
Legendre's forms in ball arithmetic: no solver of the package has a part in them.
"""

from twins.motions import TABLE, table_text

if __name__ == "__main__":
    TABLE.write_text(table_text(), encoding="utf-8")
    print(f"{TABLE}: {TABLE.stat().st_size} bytes")
