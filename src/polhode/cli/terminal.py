"""Output that every terminal can show: characters that its encoding lacks are replaced by words."""

from __future__ import annotations

import codecs
import contextlib
import io
import shlex
import shutil
import sys
import threading
import unicodedata
from collections.abc import Iterator
from pathlib import Path

HANDLER = "polhode-readable"
IN_ASCII = {
    "−": "-", "–": "-", "—": "-", "‘": "'", "’": "'", "“": '"', "”": '"', "…": "...", "·": "*", "×": "x",
    "°": " deg", "√": "sqrt ", "∞": "infinity", "≤": "<=", "≥": ">=", "≠": "!=", "≈": "~", "∝": "~", "±": "+-",
    "→": "->", "←": "<-", "∂": "d", "∑": "sum ", "Σ": "sum ", "α": "alpha", "β": "beta", "γ": "gamma",
    "Γ": "Gamma", "δ": "delta", "Δ": "Delta", "ε": "epsilon", "ζ": "zeta", "θ": "theta", "κ": "kappa",
    "λ": "lambda", "μ": "u", "µ": "u", "ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau",
    "φ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega", "Ω": "Omega", "¹": "^1", "²": "^2", "³": "^3", "⁴": "^4",
    "⁵": "^5", "⁶": "^6", "⁻": "^-", "½": "1/2", "¼": "1/4", "″": " arcsec",
}  # fmt: skip


@contextlib.contextmanager
def say_if_long(doing: str, after: float = 5.0) -> Iterator[None]:
    """Print on standard error, once, what a command is doing, where this takes longer than some seconds.

    Args:
        doing: what, like "the fit tries several models".
        after: seconds.
    """
    said = threading.Timer(after, lambda: print(f"polhode: {doing}; Ctrl-C ends it", file=sys.stderr, flush=True))
    said.daemon = True
    said.start()
    try:
        yield
    finally:
        said.cancel()


def spell_command(*arguments: str) -> str:
    """Return a command that works where this one was given: as ``.venv/bin/polhode`` where the search path has none."""
    program = sys.argv[0]
    executable = shutil.which("polhode")
    on_path = executable is not None and Path(program).exists() and Path(executable).samefile(program)
    called = "polhode" if on_path or Path(program).stem != "polhode" else program
    return shlex.join([called, *arguments])


def in_ascii(text: str) -> str:
    """Return text in ASCII: mathematical signs by name, letters without accents, the rest as ``\\\\u`` and its code.

    >>> in_ascii("I₁ + I₂ ≥ I₃ kg m², 30°, Ω = −1, Körper, 人")
    'I1 + I2 >= I3 kg m^2, 30 deg, Omega = -1, Korper, \\\\u4eba'
    """
    return "".join(c if c.isascii() else IN_ASCII.get(c) or _plainer(c) for c in text)


def _plainer(character: str) -> str:
    letters = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return letters or character.encode("ascii", "backslashreplace").decode()


def _replace_unencodable(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return in_ascii(error.object[error.start : error.end]), error.end


codecs.register_error(HANDLER, _replace_unencodable)


@contextlib.contextmanager
def readable_output() -> Iterator[None]:
    """Let standard output and error write characters beyond their encoding in ASCII, within this context."""
    before = []
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # there may be none, or something in its place
            before.append((stream, stream.errors))
            stream.reconfigure(errors=HANDLER)
    try:
        yield
    finally:
        for stream, errors in before:
            with contextlib.suppress(OSError, ValueError):  # closed, or its reader is gone
                stream.reconfigure(errors=errors)


def open_in_browser(page: Path) -> None:
    """Open a page in the user's browser, and say so where there is none."""
    import webbrowser

    if not webbrowser.open(page.resolve().as_uri()):
        print("polhode: there is no browser to open it. Open the file yourself.", file=sys.stderr)
