"""The files of JavaScript that are printed, and of which formulas."""

from __future__ import annotations

from pathlib import Path

from printing.javascript import print_file
from printing.language import Root, read
from printing.words import EXACT_SUMS

FOLDER = Path(__file__).parents[1] / "formulas"
EXACT = "polhode.exact."
FILES = {
    EXACT + "_kernel_arithmetic": "./arithmetic.js",
    "polhode.special._doubledouble": "./arithmetic.js",
    EXACT + "_formulas": "./common.js",
    EXACT + "free_body._formulas": "./free_body.js",
    EXACT + "free_body._formulas_numbers": "./free_body_numbers.js",
    EXACT + "free_body._formulas_rates": "./free_body_rates.js",
    EXACT + "free_body._formulas_reduction": "./free_body_reduction.js",
    EXACT + "free_body._formulas_setup": "./free_body_setup.js",
    EXACT + "lagrange_top._formulas": "./lagrange_top.js",
    EXACT + "lagrange_top._formulas_integrals": "./lagrange_top_integrals.js",
    EXACT + "lagrange_top._formulas_numbers": "./lagrange_top_numbers.js",
    EXACT + "lagrange_top._formulas_rates": "./lagrange_top_rates.js",
    EXACT + "lagrange_top._formulas_reduction": "./lagrange_top_reduction.js",
    EXACT + "lagrange_top._formulas_roots": "./lagrange_top_roots.js",
    EXACT + "lagrange_top._formulas_setup": "./lagrange_top_setup.js",
}
ABOUT = {
    "./arithmetic.js": "Double-double arithmetic, sines of turns, and phases reduced to a fraction of a turn.\n\n"
                       "Sources: Dekker, Numer. Math. 18 (1971) 224; Hida, Li & Bailey, ARITH-15 (2001).",
    "./common.js": "Formulas of both motions: arguments in half periods, the nome, the arithmetic–geometric mean.",
}  # fmt: skip
"""What is said of files whose modules speak of Python."""
ARITHMETIC = ["two_sum", "two_product", "halves", "add", "subtract", "multiply", "multiply_float", "square", "scale",
              "divide", "root", "root_or_zero"]  # fmt: skip
ROOTS = [
    *(Root(EXACT + "_kernel_arithmetic", name) for name in ARITHMETIC),
    Root(EXACT + "free_body._formulas_reduction", "reduction"),
    Root(EXACT + "free_body._formulas_rates", "frequencies"),
    Root(EXACT + "free_body._formulas_setup", "motion_of"),
    Root(EXACT + "free_body._formulas_setup", "axes_of"),
    Root(EXACT + "free_body._formulas_numbers", "numbers"),
    Root(EXACT + "lagrange_top._formulas_reduction", "reduction"),
    Root(EXACT + "lagrange_top._formulas_roots", "turning_points"),
    Root(EXACT + "lagrange_top._formulas_integrals", "integrals_of"),
    Root(EXACT + "lagrange_top._formulas_rates", "frequencies"),
    Root(EXACT + "lagrange_top._formulas_setup", "arguments"),
    Root(EXACT + "lagrange_top._formulas_setup", "motion_of"),
    Root(EXACT + "lagrange_top._formulas_numbers", "numbers"),
    *(Root(EXACT + "_kernel_loops", "state_at", f"{EXACT}{each}._formulas") for each in ("free_body", "lagrange_top")),
]


def word_file(name: str) -> str:
    return "../exact_sums.js" if name in EXACT_SUMS else "../words.js"


def javascript_files() -> dict[Path, str]:
    """Return path → text of all files."""
    modules = read(ROOTS)
    return {
        FOLDER / name: print_file([x for x in modules if FILES[x.name] == name], FILES, word_file, ABOUT.get(name, ""))
        for name in dict.fromkeys(FILES.values())
    }
