"""How honest and how sharp error estimates are beside saddles: ``python benchmarks/error_estimates.py [METHOD]``.

Starts and exact states are those of ``tests/twins/test_estimates.py``: 300 of each family by Taylor, else 60. Told are,
with 64, 8 and 1 samples after the start, the largest error over estimate with those beyond 3, and the estimate over the
error along the whole motion, its median and what 90 % are below; starts whose error is more than 5 % are left out. The
last lines are those of ``docs/accuracy.md``.
"""

from __future__ import annotations

import argparse
import importlib
import sys
import time
from pathlib import Path

import numpy as np

TESTS = Path(__file__).resolve().parents[1] / "tests"


def main() -> None:
    """Print a row of each family and number of samples, then the ranges of all."""
    sys.path[:0] = [str(TESTS), str(TESTS / "twins")]
    honest = importlib.import_module("test_estimates")
    given = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    given.add_argument("method", nargs="?", default="Taylor", choices=list(honest.METHODS))
    given.add_argument("--starts", type=int, help="of each family")
    options = given.parse_args()
    name = options.method
    count = options.starts or (honest.PLENTY if name == "Taylor" else honest.MANY)
    heads = "family | samples | starts | error over estimate | beyond 3 | estimate over error | 90 % below | CPU s"
    print(f"| {heads} |\n{'|---' * (heads.count('|') + 1)}|")
    found: dict[int, list[tuple[float, float, float, int]]] = {every: [] for every in honest.EVERY}
    for family in (family for family, method in honest.ROWS if method == name):
        cases, whole = honest.make(family, count), np.zeros(count)
        for every in honest.EVERY:
            begun = time.process_time()
            errors, said = honest.errors_and_estimates(cases, honest.METHODS[name], every)
            taken = time.process_time() - begun
            whole = errors if every == 1 else whole
            kept = (errors <= honest.LOST) & (whole <= honest.LOST)
            ratio, sharp = (errors / said)[kept], (said / np.maximum(whole, np.finfo(float).tiny))[kept]
            row = float(ratio.max()), float(np.median(sharp)), float(np.quantile(sharp, 0.9)), int((ratio > 3.0).sum())
            found[every].append(row)
            print(f"| {family.__name__} | {64 // every} | {kept.sum()} of {count} | {row[0]:.2g} | {row[3]} | "
                  f"{row[1]:.2g} | {row[2]:.2g} | {taken:.1f} |", flush=True)  # fmt: skip
    for every, rows in found.items():
        worst, middle, most, beyond = zip(*rows, strict=True)
        print(f"{name}, {64 // every} samples: error over estimate at most {max(worst):.2g}, {sum(beyond)} beyond 3;")
        print(f"estimate over error {min(middle):.2g} to {max(middle):.2g}; {min(most):.2g} to {max(most):.2g}")


if __name__ == "__main__":
    main()
