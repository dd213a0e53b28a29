"""``polhode derive NAME``: prints a derivation whose steps are checked, or writes it as a file."""

from __future__ import annotations

from pathlib import Path

from polhode._base import check
from polhode.cli.terminal import spell_command
from polhode.errors import InvalidInput, one_line, shown
from polhode.formats.paths import write_whole
from polhode.proving.symbolic.registry import derivation_names, describe_derivation


def run_derive(name: str | None, form: str | None, out: Path | None) -> None:
    """Print or write one derivation, or list the available ones."""
    if name is None:
        if form is not None or out is not None:
            raise InvalidInput("--to and --out are of one derivation; name it. `polhode derive` lists them.")
        width = max(map(len, derivation_names()))
        for each in derivation_names():
            print(f"{each:<{width}}  {describe_derivation(each)}")
        print(f"\nNext: {spell_command('derive', derivation_names()[0])} prints one of them.")
        return
    from polhode.proving.symbolic.rendering import ENDINGS, FORMS

    if form is not None:
        check.one_of("--to", form, FORMS)
    if out is not None and form is None:
        form = ENDINGS.get(out.suffix.lower())
        if form is None:
            raise InvalidInput(f"--out must end with {', '.join(ENDINGS)}, which selects the form; got "
                               f"{shown(str(out))}. Or say it by --to.")
    from polhode.proving.symbolic.registry import derive

    text = derive(name).render(form or "text")
    if out is None:
        print(text, end="")
        return
    with write_whole(out) as draft:
        draft.write_text(text, "utf-8")
    print(one_line(f"Written: {out}"))
