"""``recurrences`` printed as loops over a kernel's numbers, for Python and Numba."""

from __future__ import annotations

import linecache
from collections.abc import Callable
from types import FunctionType
from typing import Any

from polhode.taylor.recurrences import RECURRENCES, Coefficients, Recurrence, Word, Words


def write_function(space: dict[str, Any]) -> FunctionType:
    """Return the function that sets the k-th coefficients of an operation's results, with a kernel's names.

    Its arguments are the operation, the numbers of each lane and of all, where order k begins among these and how far
    orders are apart, k, the slots of the first result and of the argument, and the node's number.
    """
    lines = ["def function(operation, flat, z, base, width, k, out, x, number):"]
    for operation, recurrence in RECURRENCES.items():
        first, later = _print(recurrence)
        lines += [f"    if operation == {operation:d}:  # {operation.name}", "        if k == 0:"]
        lines += [f"            {line}" for line in [*first, "return"]]
        lines += [f"        {line}" for line in [*later, "return"]]
    text, name = "\n".join(lines), "<recurrences as loops>"
    linecache.cache[name] = len(text), None, text.splitlines(keepends=True), name  # for tracebacks
    written: dict[str, Any] = {}
    exec(compile(text, name, "exec"), space, written)
    return written["function"]


def _print(recurrence: Recurrence) -> tuple[list[str], list[str]]:
    """Return the statements for order zero, and those for another one."""
    first, later, number = _Loops(), _Loops(), _Text("number")
    slots = ["out", *(f"out + {i}" for i in range(1, recurrence.results))]
    values = recurrence.values(first, _Text("z[x]"), number)
    first.lines += [f"z[{slot}] = {value}" for slot, value in zip(slots, values, strict=True)]
    x, *own = (later.of(name, slot) for name, slot in zip("xuvwd", ["x", *slots], strict=False))
    for slot, value in zip(slots, recurrence.coefficients(later, _Text("k"), x, own, number), strict=False):
        later.lines.append(f"z[base + {slot}] = {value}")
    return first.lines, later.lines


class _Text(Word):
    """The text of a number."""

    def __init__(self, text: str) -> None:
        self.text = text

    def __str__(self) -> str:
        return self.text

    def operate(self, symbol: str, left: Any, right: Any) -> _Text:
        return _Text(f"({left} {symbol} {right})")

    def __neg__(self) -> _Text:
        return _Text(f"-{self}")


class _Loops(Words):
    """The words of ``recurrences``: statements so far, and the indices that move in the loop that is written."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.indices: dict[str, tuple[str, str]] = {}

    def __getattr__(self, name: str) -> Callable[..., _Text]:
        return lambda *numbers: _Text(f"{name}({', '.join(map(str, numbers))})")

    def eccentric_anomaly(self, mean_anomaly: _Text, number: _Text) -> _Text:
        each = f"flat[out * LANES + lane] = eccentric_anomaly_at(flat[x * LANES + lane], {number})"
        self.lines += ["for lane in range(LANES):", f"    {each}"]
        return _Text("z[out]")

    def share(self, x: _Text) -> _Text:
        self.lines.append(f"shared = {x}")
        return _Text("shared")

    def of(self, name: str, slot: str) -> Coefficients:
        """Return the coefficients of a node; in a loop their index goes along with j, or against it."""

        def find(order: Any) -> _Text:
            match str(order):
                case "0":
                    return _Text(f"z[{slot}]")
                case "k":
                    return _Text(f"z[base + {slot}]")
                case "j":
                    index, start, sign = name, slot, "+"
                case _:
                    index, start, sign = f"{name}_late", f"base + {slot}", "-"
            self.indices[index] = start, sign
            return _Text(f"z[{index}]")

        return Coefficients(find)

    def totals(self, first: Any, stop: Any, starts: tuple[Any, ...], terms: Callable[[Any], Any]) -> list[_Text]:
        before, self.lines, self.indices = self.lines, [], {}
        totals = [_Text(f"total_{i}") for i in range(len(starts))]
        for total, part in zip(totals, terms(_Text("j")), strict=True):
            sign, size = ("-", part.text[1:]) if part.text.startswith("-") else ("+", part)
            self.lines.append(f"{total} = {total} {sign} {size}")
        self.lines += [f"{index} = {index} {sign} width" for index, (_, sign) in self.indices.items()]
        before += [f"{total} = {start or 'spread(0.0)'}" for total, start in zip(totals, starts, strict=True)]
        for index, (place, sign) in self.indices.items():
            before.append(f"{index} = {place} {sign} {first} * width" if first else f"{index} = {place}")
        self.lines = [*before, f"for j in range({first}, {stop}):", *(f"    {line}" for line in self.lines)]
        return totals
