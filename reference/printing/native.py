"""The C header and the Rust crate: which formulas they have, and how their files are put together."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import polhode
from printing.c import C
from printing.expressions import comment, ordered
from printing.language import Root, read
from printing.rust import Rust
from printing.tree import Module

HERE = Path(__file__).parent
REFERENCE = HERE.parent
EXACT = "polhode.exact."
FREE, TOP = f"{EXACT}free_body.", f"{EXACT}lagrange_top."
ROOTS = (
    Root(f"{FREE}_formulas_reduction", "reduction"),
    Root(f"{FREE}_formulas_rates", "frequencies"),
    Root(f"{FREE}_formulas_setup", "motion_of"),
    Root(f"{FREE}_formulas_numbers", "numbers"),
    Root(f"{EXACT}_kernel_loops", "state_at", given=f"{FREE}_formulas"),
    Root(f"{TOP}_formulas_reduction", "reduction"),
    Root(f"{TOP}_formulas_roots", "turning_points"),
    Root(f"{TOP}_formulas_integrals", "integrals_of"),
    Root(f"{TOP}_formulas_rates", "frequencies"),
    Root(f"{TOP}_formulas_setup", "arguments"),
    Root(f"{TOP}_formulas_setup", "motion_of"),
    Root(f"{TOP}_formulas_numbers", "numbers"),
    Root(f"{EXACT}_kernel_loops", "state_at", given=f"{TOP}_formulas"),
)
ALLOWED = (
    "// names are those of Python, and a formula may leave something unused",
    "#![allow(dead_code, non_snake_case, unused_imports, unused_variables)]",
)
BOTH = "both"
PARTS = (BOTH, "free_body", "lagrange_top")
PRINTED = "Printed from src/polhode/exact by `python -m printing` in reference/: change the formulas, and print again."


def part_of(module: str) -> str:
    return next((part for part in PARTS if f".{part}." in module), BOTH)


def native_files() -> dict[Path, str]:
    """Return path → text of the header and of the crate's modules."""
    modules = read(ROOTS)
    crate = REFERENCE / "rust" / "src"
    return {REFERENCE / "polhode.h": _header(modules)} | {crate / name: text for name, text in _crate(modules).items()}


def _by_part(language: C | Rust, modules: tuple[Module, ...]) -> dict[str, list[str]]:
    """Return the lines of each part; what both motions need comes first."""
    definitions = [*ordered(modules)]
    return {
        part: [line for module, node in definitions if part_of(module) == part
               for line in language.definition(module, node)]
        for part in PARTS
    }  # fmt: skip


def _header(modules: tuple[Module, ...]) -> str:
    text = (HERE / "polhode.in.h").read_text("utf-8").replace("@version@", polhode.__version__)
    for part, lines in _by_part(C(modules), modules).items():
        text = text.replace(f"@{part}@\n", "".join(f"{line}\n" for line in lines))
    return text


def _crate(modules: tuple[Module, ...]) -> dict[str, str]:
    """Return name of a file → text."""
    language = Rust(modules, {module.name: part_of(module.name) for module in modules})
    parts = _by_part(language, modules)
    return {f"{part}.rs": "\n".join([*_head(part, language), *lines]).rstrip() + "\n" for part, lines in parts.items()}


def _head(part: str, language: Rust) -> Iterator[str]:
    yield "// SPDX-License-Identifier: MIT"
    yield from comment(PRINTED, 0, "// ", "// ")
    yield from ALLOWED
    yield ""
    if part != BOTH:
        yield f"use crate::{BOTH};"
    yield "use crate::words::*;"
    yield from ("", *language.short_names(part), "")
