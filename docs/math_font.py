"""The math font of documents and derivations: ``python docs/math_font.py FONT``, with fonttools[woff].

Browsers build roots, brackets and dots by the MATH table of a font; without one, roots are too short and dots lost in
the line above. No browser ships such a font, and few systems do. So a part of STIX Two Math comes with polhode: the
signs that its formulas use, in a fifth of the size. FONT is that of the npm package @fontsource/stix-two-math 5.3.0,
files/stix-two-math-latin-400-normal.woff2. Its licence is the SIL Open Font License 1.1; the part has its own name.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

NAME = "polhode math"
FILE = Path(__file__).parents[1] / "src" / "polhode" / "symbolic" / "assets" / "math.woff2"
RANGES = (
    (0x20, 0x7E), (0xA0, 0xBF), (0xD7, 0xD7), (0xF7, 0xF7),  # Latin letters and digits, and signs beside them
    (0x2C6, 0x2DC), (0x300, 0x30C), (0x391, 0x3F6),  # accents, Greek
    (0x2010, 0x2063), (0x2070, 0x208E), (0x20D6, 0x20D7), (0x20DB, 0x20DC),  # dashes, primes, small digits, dots above
    (0x210B, 0x2135), (0x2190, 0x21A9), (0x21C4, 0x21CC), (0x21D0, 0x21D4),  # letters with a meaning, arrows
    (0x2200, 0x22D5), (0x22EE, 0x22F1), (0x2308, 0x230B), (0x2329, 0x232A), (0x23B4, 0x23B5), (0x23DC, 0x23DF),
    (0x27E8, 0x27E9), (0x27F5, 0x27FA), (0x2A00, 0x2A02), (0x2A2F, 0x2A2F), (0x2A7D, 0x2A7E),
    (0x1D400, 0x1D49B), (0x1D49C, 0x1D4CF), (0x1D504, 0x1D537), (0x1D538, 0x1D56B), (0x1D6A4, 0x1D755),
)  # fmt: skip
"""Code points that are kept, the last of each pair included; the last line: italic, bold, script and other letters."""


def make_part(source: Path, target: Path) -> int:
    """Write the part of a math font that formulas need, as WOFF2; return its size in bytes.

    Args:
        source: of the font, with a MATH table.
        target: the file.
    """
    font = TTFont(source)
    options = subset.Options()
    options.layout_features = ["ssty", "dtls", "flac", "ccmp", "mark", "mkmk"]
    options.notdef_outline = True
    options.hinting = False
    options.desubroutinize = False
    part = subset.Subsetter(options)
    part.populate(unicodes=[code for first, last in RANGES for code in range(first, last + 1)])
    part.subset(font)
    for record in font["name"].names:
        if record.nameID in (1, 3, 4, 6, 16, 18):
            record.string = NAME if record.nameID != 6 else NAME.replace(" ", "-")
    font.flavor = "woff2"
    target.parent.mkdir(exist_ok=True)
    font.save(target)
    return target.stat().st_size


if __name__ == "__main__":
    print(make_part(Path(sys.argv[1]), FILE), "bytes")
