"""A reader of Rocq's definitions of floating-point algorithms, which evaluates them as Rocq means them.

Numbers are exact fractions; ``rnd`` alone rounds, to the nearest binary64 number with ties to even. So a definition
that forgets to round an operation gives other values than the code, as does one with another order of operations.
"""

import re
from fractions import Fraction

TOKEN = re.compile(r"\s*(:=|->|[A-Za-z_][\w']*|\d+|[()+\-*/,:])")


def definitions(text):
    """Return {name: (parameters, body)} of all definitions in a file without the bodies that are no arithmetic."""
    text = re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL)
    found = {}
    statement = re.compile(r"^Definition (\w+)([^\n]*?) :=(.*?)\.\s*\n", re.MULTILINE | re.DOTALL)
    for name, parameters, body in statement.findall(text):
        if ": Prop" not in parameters and ": Z" not in parameters and "exists" not in body and ": R" != parameters[-3:]:
            names = re.sub(r"\((\w+) : [^()]*\)", r"\1", parameters).split()
            found[name] = (names, body)
    return found


class Reader:
    """Reads one expression and evaluates it in an environment."""

    def __init__(self, text, environment):
        self.tokens = [*TOKEN.findall(text), ""]
        assert "".join(self.tokens) == re.sub(r"\s", "", text), f"not read: {text}"
        self.place = 0
        self.environment = environment

    def take(self, *expected):
        token = self.tokens[self.place]
        assert not expected or token in expected, f"{token!r} where {expected} should be"
        self.place += 1
        return token

    def next(self):
        return self.tokens[self.place]

    def expression(self):
        if self.next() == "let":
            return self.let()
        value = self.term()
        while self.next() in ("+", "-"):
            value = value + self.term() if self.take() == "+" else value - self.term()
        return value

    def let(self):
        self.take("let")
        names = []
        while (token := self.take()) != ":=":
            names += [] if token in "()," else [token]
        value = self.expression()
        self.take("in")
        self.environment = {**self.environment, **dict(zip(names, value if len(names) > 1 else (value,), strict=True))}
        return self.expression()

    def term(self):
        value = self.factor()
        while self.next() in ("*", "/"):
            value = value * self.factor() if self.take() == "*" else value / self.factor()
        return value

    def factor(self):
        if self.next() == "-":
            self.take()
            return -self.factor()
        head = self.atom()
        arguments = []
        while callable(head) and (self.next() == "(" or re.match(r"\w", self.next())) and self.next() != "in":
            arguments.append(self.atom())
        return head(*arguments) if arguments else head

    def atom(self):
        token = self.take()
        if token != "(":
            return Fraction(int(token)) if token.isdigit() else self.environment[token]
        values = [self.expression()]
        while self.next() == ",":
            self.take()
            values.append(self.expression())
        self.take(")")
        return values[0] if len(values) == 1 else tuple(values)


def rounded(x):
    """Return the nearest binary64 number."""
    return Fraction(float(x))


def functions(*texts):
    """Return the definitions of files as functions of fractions, by name."""
    environment = {"rnd": rounded}
    for text in texts:
        for name, (names, body) in definitions(text).items():
            def call(*values, names=names, body=body):
                own = dict(zip(names, values, strict=True))
                reader = Reader(body, {**environment, **own})
                value = reader.expression()
                assert reader.next() == "", f"{reader.next()!r} is left over"
                return value

            environment[name] = call
    return environment
