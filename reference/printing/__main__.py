"""Prints all files anew: ``python -m printing``, in ``reference/``."""

from printing.javascript_files import javascript_files
from printing.native import native_files

for path, text in (javascript_files() | native_files()).items():
    path.parent.mkdir(exist_ok=True)
    path.write_text(text, "utf-8")
    print(f"{path.relative_to(path.parents[1])}: {text.count(chr(10))} lines")
