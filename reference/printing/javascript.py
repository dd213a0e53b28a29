"""Prints formulas as JavaScript: a tuple is an array, a record an object, names have humps."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from printing.layout import SOFT, WIDTH, Broken, Document, Group, Line, Nest, enclosed, laid_out
from printing.tree import (
    FLAG,
    Assign,
    Binary,
    Call,
    Choice,
    Constant,
    Definition,
    Expression,
    Field,
    Function,
    Global,
    If,
    Item,
    Leave,
    Literal,
    Make,
    Module,
    Name,
    Notes,
    Part,
    Record,
    Repeat,
    Return,
    Scalar,
    Section,
    Statement,
    Structure,
    Target,
    Type,
    Unary,
)

STEP = 2
OPERATORS = {"==": "===", "!=": "!==", "and": "&&", "or": "||"}
STRENGTH = {"||": 1, "&&": 2, "===": 3, "!==": 3, "<": 4, ">": 4, "<=": 4, ">=": 4, "+": 5, "-": 5, "*": 6, "/": 6}
COMPARISONS = ("===", "!==", "<", ">", "<=", ">=")
CLEARER = {"||": ("&&",), "===": COMPARISONS, "!==": COMPARISONS}
CHOICE, UNARY, ATOM = 0, 7, 9  # strengths beside these: what binds less is put in parentheses
WORDS = {
    "square_root": "Math.sqrt", "exponential": "Math.exp", "floor": "Math.floor", "abs": "Math.abs",
    "arctangent": "Math.atan", "angle_of": "Math.atan2", "logarithm": "Math.log", "hyperbolic_sine": "Math.sinh",
    "area_of_sine": "Math.asinh",
}  # fmt: skip
"""Others are functions of words.js and exact_sums.js."""
IDENTITY = "as_sum"  # both a pair and an exact sum are arrays
WordFile = Callable[[str], str]
CONSTANTS = {"pi": "Math.PI", "nan": "NaN", "inf": "Infinity"}
RESERVED = {
    "arguments", "await", "case", "catch", "class", "const", "default", "delete", "do", "enum", "eval", "export",
    "extends", "finally", "function", "import", "in", "instanceof", "interface", "let", "new", "null", "package",
    "private", "protected", "public", "static", "super", "switch", "this", "throw", "try", "typeof", "var", "void",
    "with", "yield",
}  # fmt: skip
IDENTIFIER = re.compile(r"``([a-z_]\w*)``")


def print_file(modules: Sequence[Module], files: Mapping[str, str], word_file: WordFile, about: str = "") -> str:
    """Return the text of a file.

    Args:
        modules: that it has.
        files: name of a module → name of its file, from the folder on.
        word_file: name of a word → name of its file.
        about: what the file has; else the first module's docstring says so.
    """
    here = files[modules[0].name]
    sources = ", ".join(f"src/{module.name.replace('.', '/')}.py" for module in modules)
    said = f"Printed from {sources} by `python -m printing`: change that, and print again.\n\n"
    said += about or modules[0].docstring
    parts = ["\n".join(_comment(said)), *_imports(modules, files, here, word_file)]
    for module in modules:
        parts += [_definition(each) for each in _in_groups(module.definitions)]
    return "\n\n".join(parts) + "\n"


def _imports(
    modules: Sequence[Module], files: Mapping[str, str], here: str, word_file: WordFile
) -> Iterator[str]:
    taken: dict[str, set[str]] = {}
    for function in (x for module in modules for x in module.definitions if isinstance(x, Function)):
        for module, name in function.calls:
            if module:
                taken.setdefault(files[module], set()).add(name_of(name, module))
            elif name not in WORDS and name != IDENTITY:
                taken.setdefault(word_file(name), set()).add(hump(name))
    taken.pop(here, None)
    lines = []
    for file in sorted(taken):
        names = enclosed("{", sorted(taken[file], key=str.lower), "}", " ")
        lines.append(laid_out(("import ", names, f' from "{file}";'), STEP))
    if lines:
        yield "\n".join(lines)


def _in_groups(definitions: Iterable[Definition]) -> Iterator[list[Definition]]:
    """Yield constants that follow each other together, and each other definition by itself."""
    constants: list[Definition] = []
    for each in definitions:
        if isinstance(each, Constant):
            constants.append(each)
            continue
        if constants:
            yield constants
            constants = []
        yield [each]
    if constants:
        yield constants


# ---------------------------------------------------------------------- names and comments


def hump(name: str) -> str:
    """Return a name with humps in place of underscores; constants keep theirs, and what is private its first one."""
    bare = name.lstrip("_")
    first, *rest = [bare] if bare.isupper() else bare.split("_")
    found = name[: len(name) - len(bare)] + first + "".join(part[:1].upper() + part[1:] for part in rest)
    return found + "_" if found in RESERVED else found


def name_of(name: str, module: str) -> str:
    return CONSTANTS[name] if module == "math" else hump(name)


def _comment(text: str, prefix: str = "// ", indent: int = 0) -> list[str]:
    """Return the lines of a comment, with Python's names as they are called here."""
    text = IDENTIFIER.sub(lambda match: f"`{hump(match[1])}`", text).replace("``", "`")
    before = " " * indent + prefix
    found = []
    for paragraph in text.split("\n\n"):
        lines = paragraph.splitlines()
        if any(len(before + x) > WIDTH for x in lines):
            apart = lines if paragraph.startswith((" ", "Args", "@")) else [paragraph]
            lines = [line for each in apart for line in textwrap.wrap(each, WIDTH - len(before))]
        found += ["", *lines]
    return [(before + line).rstrip() for line in found[1:]]


def _documentation(text: str) -> str:
    lines = _comment(text, " * ")
    if len(lines) == 1 and len(lines[0]) + 5 <= WIDTH:
        return f"/** {lines[0].removeprefix(' * ')} */\n"
    return "\n".join(["/**", *lines, " */"]) + "\n" if text else ""


def _noted(lines: str, notes: Notes, indent: int) -> str:
    """Return a statement with its comments; one beside it comes above where it has no room."""
    above = [line for note in notes.above for line in _comment(note, indent=indent)]
    beside = " " + "".join(_comment(notes.beside)) if notes.beside else ""
    if "\n" in lines or len(lines + beside) > WIDTH:
        above += _comment(notes.beside, indent=indent) if beside else []
        beside = ""
    return "\n".join([*above, lines + beside])


# ---------------------------------------------------------------------- definitions


def _definition(group: list[Definition]) -> str:
    match group[0]:
        case Section(title):
            return "// " + "-" * 70 + _comment(title, " ")[0]
        case Structure(record, docstring, notes):
            return _structure(record, docstring, notes)
        case Function() as function:
            return _function(function)
    return "\n".join(_constant(each) for each in group if isinstance(each, Constant))


def _constant(constant: Constant) -> str:
    values = constant.value if isinstance(constant.value, tuple) else (constant.value,)
    text = ", ".join(map(number, values))
    text = f"[{text}]" if isinstance(constant.value, tuple) else text
    source = f"{constant.source}" if constant.source else ""
    beside = "; ".join(x for x in (source, constant.notes.beside) if x)
    return _noted(f"export const {constant.name} = {text};", Notes(constant.notes.above, beside), 0)


def _structure(record: Record, docstring: str, notes: Sequence[Notes]) -> str:
    lines = [f"{docstring}\n", f"@typedef {{object}} {record.name}"]
    for (name, kind), note in zip(record.fields, notes, strict=True):
        said = " ".join([*note.above, note.beside]).strip()
        lines.append(f"@property {{{type_of(kind)}}} {hump(name)}" + (f" {said}" if said else ""))
    return _documentation("\n".join(lines)).rstrip()


def type_of(kind: Type) -> str:
    """Return what a type is called in documentation."""
    if isinstance(kind, Record):
        return kind.name
    if isinstance(kind, Scalar):
        return "boolean" if kind == FLAG else "number"
    return "number[]" if all(isinstance(each, Scalar) for each in getattr(kind, "items", ())) else "Array"


def _function(function: Function) -> str:
    body = _Body(function)
    words = "export function" if not function.name.startswith("_") else "function"
    parameters = enclosed("(", [hump(name) for name, _ in function.parameters], ")")
    head = laid_out((f"{words} {hump(function.name)}", parameters, " {"), STEP)
    lines = body.block(function.body, STEP)
    return _documentation(function.docstring) + "\n".join([head, *lines, "}"])


class _Body:
    """Prints the statements of one function."""

    def __init__(self, function: Function) -> None:
        self.rebound = {name for each in _assignments(function.body) for name in each.types if name not in each.fresh}

    def block(self, statements: Sequence[Statement], indent: int) -> list[str]:
        return [_noted(self.statement(each, indent), each.notes, indent) for each in statements]

    def statement(self, statement: Statement, indent: int) -> str:
        margin = " " * indent
        match statement:
            case Assign():
                return margin + self._assignment(statement, indent)
            case Return(value):
                return margin + laid_out(("return ", _returned(value), ";"), STEP, indent)
            case Leave():
                return margin + "break;"
            case If(test, (only,), (), _) if isinstance(only, Return | Leave) and only.notes == Notes():
                one = margin + laid_out(("if (", expression(test), ") ", self.statement(only, 0)), STEP, indent)
                if len(one) <= WIDTH and "\n" not in one:
                    return one
                return self._branches(statement, indent)
            case If():
                return self._branches(statement, indent)
            case Repeat(name, first, end, body):
                k = hump(name)
                head = f"for (let {k} = {flat(first)}; {k} < {flat(end)}; {k}++) {{"
                return "\n".join([margin + head, *self.block(body, indent + STEP), margin + "}"])

    def _branches(self, statement: If, indent: int) -> str:
        margin = " " * indent
        head = margin + laid_out(("if (", expression(statement.test), ") {"), STEP, indent)
        lines = [head, *self.block(statement.body, indent + STEP)]
        if statement.otherwise:
            lines += [margin + "} else {", *self.block(statement.otherwise, indent + STEP)]
        return "\n".join([*lines, margin + "}"])

    def _assignment(self, assign: Assign, indent: int) -> str:
        names, before, after = set(assign.types), "", ";"
        target = pattern(assign.target)
        if assign.fresh == names:
            target = ("let " if names & self.rebound else "const ") + target
        else:
            if assign.fresh:
                before = f"let {', '.join(sorted(map(hump, assign.fresh)))};\n{' ' * indent}"
            if not isinstance(assign.target, str):  # a statement that begins with a brace would be a block
                target, after = "(" + target, ");"
        value = expression(assign.value)
        if isinstance(assign.value, Binary | Choice):
            return before + laid_out((Group((target, " =", Nest((Line(), value)))), after), STEP, indent)
        return before + laid_out((target, " = ", value, after), STEP, indent)


def _assignments(statements: Iterable[Statement]) -> Iterator[Assign]:
    for each in statements:
        match each:
            case Assign():
                yield each
            case If(_, body, otherwise):
                yield from _assignments((*body, *otherwise))
            case Repeat(body=body):
                yield from _assignments(body)


def pattern(target: Target) -> str:
    """Return what takes the items of an array, by their numbers: the iterator of [a, b] takes node twice the time."""
    if isinstance(target, str):
        return hump(target)
    return "{ " + ", ".join(f"{k}: {pattern(each)}" for k, each in enumerate(target) if each != "_") + " }"


# ---------------------------------------------------------------------- expressions


def number(value: float) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    text = repr(int(value)) if value == int(value) and abs(value) < 1e21 else repr(value)
    return re.sub(r"e([+-]?)0*", lambda match: "e" + match[1].replace("+", ""), text)


def flat(value: Expression) -> str:
    return laid_out(expression(value), STEP).replace("\n", " ")


def _returned(value: Expression) -> Document:
    """Return a value, in parentheses where it is broken: else JavaScript would end the statement there."""
    inner = expression(value)
    return Group((Broken("("), Nest((SOFT, inner)), SOFT, Broken(")"))) if isinstance(value, Binary | Choice) else inner


def expression(value: Expression, around: int = CHOICE) -> Document:
    """Return an expression, in parentheses where it binds less than what is around it."""
    text, strength = _expression(value)
    return ("(", text, ")") if strength < around else text


def _expression(value: Expression) -> tuple[Document, int]:
    """Return an expression and how strongly it binds."""
    match value:
        case Literal(literal):
            return number(literal), ATOM
        case Name(name):
            return hump(name), ATOM
        case Global(name, module):
            return name_of(name, module), ATOM
        case Item(of, index):
            if isinstance(of.type, Record):
                return (expression(of, ATOM), f".{hump(of.type.fields[index][0])}"), ATOM
            return (expression(of, ATOM), f"[{index}]"), ATOM
        case Part(of, low, high):
            return (expression(of, ATOM), f".slice({low}, {high})"), ATOM
        case Field(of, name):
            return (expression(of, ATOM), f".{hump(name)}"), ATOM
        case Unary(operator, operand):
            return ({"-": "-", "not": "!"}[operator], expression(operand, UNARY)), UNARY
        case Binary(operator, left, right):
            sign = OPERATORS.get(operator, operator)
            strength = STRENGTH[sign]
            text = (_operand(sign, left, strength), f" {sign}", Line(), _operand(sign, right, strength + 1))
            return Group(text), strength
        case Choice(test, yes, no):
            parts = (expression(test, CHOICE + 1), Nest((Line(), "? ", expression(yes, CHOICE + 1), Line(), ": ",
                                                         expression(no))))  # fmt: skip
            return Group(parts), CHOICE
        case Call(name, "", (only,)) if name == IDENTITY:
            return _expression(only)
        case Call(name, module, arguments):
            called = name_of(name, module) if module else WORDS.get(name, hump(name))
            return (called, enclosed("(", map(expression, arguments), ")")), ATOM
        case Make(items, Record(fields=fields)):
            entries = [_entry(hump(name), item) for (name, _), item in zip(fields, items, strict=True)]
            return enclosed("{", entries, "}", " "), ATOM
        case Make(items):
            return enclosed("[", map(expression, items), "]"), ATOM


def _operand(sign: str, value: Expression, around: int) -> Document:
    """Return one side of an operator; "and" in "or", and a comparison in another, get parentheses for the reader."""
    inner = OPERATORS.get(value.operator, value.operator) if isinstance(value, Binary) else ""
    return expression(value, ATOM if inner in CLEARER.get(sign, ()) else around)


def _entry(name: str, value: Expression) -> Document:
    text = expression(value)
    return name if text == name else (f"{name}: ", text)
