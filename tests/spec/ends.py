"""Every key of every kind's spec at the ends of its range; keys come from the models, so a new one is drawn too."""

import copy
import itertools
import tomllib
import types
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel

from polhode.errors import PolhodeError
from polhode.kinds.reading import build_spec
from polhode.kinds.registry import find_kind
from polhode.spec.fields import UNIT
from polhode.spec.models import SpecFile
from spec.mutations import bases, spec_of

NUMBERS = ["0", "-0.0", "5e-324", "1e-308", "1e-300", "1e-150", "1e-50", "1e-20", "-1", "1e20", "1e50", "1e150",
           "1e300", "1.7e308", "-1e300", "-1e-300", "nan", "inf", "-inf"]  # fmt: skip
WHOLES = [0, 1, -1, 2**31, 2**63, -(2**63), 10**30]
TEXTS = ["", "x", "a" * 3000]
LISTS = ["empty", "one", "long"]
MILD = ["1", "0.5", "0.1", "2", "10", "0.01", "1000", "45", "-1"]
SPECS = ("body", "spin", "time", "export")


class Key(NamedTuple):
    """A place of a spec that holds one value.

    Attributes:
        kind: of the spec.
        path: names and, for items of a list, 0; "*" for any name of a table that has no fixed ones.
        form: "number", "whole", "text" or "list".
        unit: of numbers, "" for plain ones.
        above: what is annotated along the path, of which tables and lists that are missing are made.
    """

    kind: str
    path: tuple[str | int, ...]
    form: str
    unit: str
    above: tuple[Any, ...]

    def holding(self, end):
        """Return what a spec holds there for an end of the range."""
        if self.form != "number":
            return end
        return f"{end} {self.unit}" if self.unit else float(end)

    @property
    def mild(self):
        """Values of which one may do."""
        if self.form == "number":
            return [self.holding(one) for one in MILD]
        return {"whole": [1, 2, 3, 10, -1000], "text": [], "list": []}[self.form]

    @property
    def ends(self):
        return {"number": NUMBERS, "whole": WHOLES, "text": TEXTS, "list": LISTS}[self.form]

    def __str__(self):
        return f"{self.kind}: {'.'.join(map(str, self.path))}"


def keys_of(kind):
    """Yield the keys of all tables that specs of a kind may have."""
    table = find_kind(kind).table
    yield from _keys(kind, table, ("system",), (table,))
    for name in table.beside:  # tables of their own at the top of a file
        at, marks = bare(table.model_fields[name].annotation, table.model_fields[name].metadata)
        yield from _of_annotation(kind, at, marks, (name,), ())
    for name in SPECS:
        if name in table.takes or name == "export":
            model = bare(SpecFile.model_fields[name].annotation)[0]
            yield from _keys(kind, model, (name,), (model,))


def _keys(kind, model, path, above):
    for name, field in model.model_fields.items():
        if name != "kind" and name not in getattr(model, "beside", ()):
            at, marks = bare(field.annotation, field.metadata)
            yield from _of_annotation(kind, at, marks, (*path, name), above)


def _of_annotation(kind, at, marks, path, above):
    unit, above = unit_of(marks), (*above, (at, marks))
    if isinstance(at, type) and issubclass(at, BaseModel):
        yield from _keys(kind, at, path, (*above[:-1], at))
    elif get_origin(at) is dict:
        yield from _of_annotation(kind, *bare(get_args(at)[1]), (*path, "*"), above)
    elif get_origin(at) in (tuple, list):
        yield Key(kind, path, "list", "", above)
        if unit is not None:  # read as a whole, such as an attitude
            yield Key(kind, (*path, 0), "number", unit, (*above, (float, marks)))
        else:
            yield from _of_annotation(kind, *bare(get_args(at)[0]), (*path, 0), above)
    else:
        form = "number" if at is float else "whole" if at is int else "text"
        yield Key(kind, path, form, (unit or "") if form == "number" else "", above)


def bare(at, marks=()):
    """Return an annotation without None and without what is annotated to it, which comes beside."""
    marks = list(marks)
    while True:
        if get_origin(at) is Annotated:
            at, *more = get_args(at)
            marks += more
        elif get_origin(at) in (Union, types.UnionType):
            at = next(choice for choice in get_args(at) if choice is not type(None))
        else:
            return at, marks


def unit_of(marks):
    """Return the unit of what reads a number, "" for plain ones; None where nothing does."""
    units = (getattr(getattr(mark, "func", None), UNIT, None) for mark in marks)
    return next((unit for unit in units if unit is not None), None)


def built(at, marks=(), mild="1"):
    """Return something mild that a key with this annotation may hold."""
    at, marks = bare(at, marks)
    unit = unit_of(marks)
    if isinstance(at, type) and issubclass(at, BaseModel):
        needed = {name: field for name, field in at.model_fields.items() if field.is_required()}
        return {name: built(field.annotation, field.metadata, mild) for name, field in needed.items()}
    if get_origin(at) is dict:
        return {}
    if get_origin(at) is tuple:
        inner = [one for one in get_args(at) if one is not Ellipsis]
        return [built(one, () if unit is None else marks, mild) for one in inner]
    if get_origin(at) is list:
        return [built(get_args(at)[0], (), mild)]
    if get_origin(at) is Literal:
        return get_args(at)[0]
    return {float: f"{mild} {unit}" if unit else float(mild), int: 1, bool: True}.get(at, "x")


def hosts_of(kind, folder):
    """Return the specs of a kind that can be read and that keys are set in, the kind's own example first.

    The bodies and spins of other kinds' specs go with any kind that takes them.
    """
    found, takes = [tomllib.loads(find_kind(kind).example)], find_kind(kind).table.takes
    others = list(bases().values())
    found += [tables for tables in others if tables.get("system", {}).get("kind", "free-body") == kind]
    kept = {name: found[0][name] for name in ("system", "time") if name in found[0]}
    for tables in others if "body" in takes else ():
        if "body" in tables:
            found.append(copy.deepcopy(kept | {name: tables[name] for name in takes if name in tables}))
    for tables in found:
        if "time" in takes:
            tables.setdefault("time", {})["samples"] = 12
    return [tables for tables in found if _is_read(tables, folder)]


def changed(tables, key, value):
    """Return a copy of a spec with a value at a key; tables and lists that are missing are made."""
    tables = copy.deepcopy(tables)
    at = tables
    for k, name in enumerate(key.path):
        name = _step(at, key.path, k)
        if not isinstance(at, list if isinstance(name, int) else dict):
            return None
        if k == len(key.path) - 1:
            if isinstance(at, list):
                at[name : name + 1] = [value]
            else:
                at[name] = value
        elif isinstance(at, dict):
            above = key.above[k]
            at = at.setdefault(name, built(*above) if isinstance(above, tuple) else built(above))
        elif name < len(at):
            at = at[name]
        else:
            return None
    return tables


def held(tables, path):
    """Return what stands at a path; None for nothing."""
    for k in range(len(path)):
        try:
            tables = tables[_step(tables, path, k)]
        except (KeyError, IndexError, TypeError):
            return None
    return tables


def _step(at, path, k):
    """Return the name or place that a step of a path means: of a list of tables the first that has the next key."""
    if path[k] == "*":
        return next(iter(at), "D_J")
    following = path[k + 1] if k + 1 < len(path) else None
    if isinstance(path[k], int) and isinstance(following, str) and isinstance(at, list):
        return next((place for place, item in enumerate(at) if isinstance(item, dict) and following in item), 0)
    return path[k]


def host_of(key, hosts, folder):
    """Return a spec that can be read and holds a key, from one with the key or by setting it to something mild.

    Where the rules forbid it beside another key of the table, that one is left out; where they ask for another, that
    one is set too.
    """
    for tables in hosts:
        if held(tables, key.path) is not None:
            return tables
    if key.path[0] != "system" or not key.mild:  # those of bodies and spins stand in some example
        return None
    for tables, value in itertools.product(hosts, key.mild):
        if (made := changed(tables, key, value)) is None:
            continue
        for tried in (made, *_without_one(made, key), *_with_one(made, key)):
            if _is_read(tried, folder):
                return tried
    return None


def _without_one(tables, key):
    around = _table_around(tables, key)
    for name in held(tables, around):
        if name not in key.path:
            tried = copy.deepcopy(tables)
            del held(tried, around)[name]
            yield tried


def _with_one(tables, key):
    around = _table_around(tables, key)
    model = key.above[len(around) - 1]
    for name, field in model.model_fields.items():
        if name not in held(tables, around):
            tried = copy.deepcopy(tables)
            held(tried, around)[name] = built(field.annotation, field.metadata, "0.5")
            yield tried


def _table_around(tables, key):
    """Return the path of the innermost table of fixed names that a key is in."""
    lengths = range(1, len(key.path))
    return max((key.path[:k] for k in lengths if not isinstance(key.above[k - 1], tuple)), key=len)


def _is_read(tables, folder):
    try:
        build_spec(tables, folder / "host.toml")
    except PolhodeError:
        return False
    return True


def at_end(host, key, end):
    """Return the text of a spec with a key at an end of its range; None where there is no list to lengthen."""
    value = key.holding(end)
    if key.form == "list":
        there = held(host, key.path)
        there = there if isinstance(there, list) and there else [1.0]
        value = {"empty": [], "one": there[:1], "long": there * 400}[end]
    made = changed(host, key, value)
    return None if made is None else spec_of(made)
