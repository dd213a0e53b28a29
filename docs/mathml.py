"""Formulas as MathML, which browsers draw themselves: no script, and no request to anywhere."""

import re

from docutils import nodes
from latex2mathml.converter import convert

from polhode.proving.symbolic.rendering import STRUT


def as_mathml(node, display):
    """Browsers know bold letters by their style alone, and let the root of a small letter sink below the line."""
    formula = convert(node.astext(), display=display).replace("<msqrt>", f"<msqrt>{STRUT}")
    return re.sub(r'mathvariant="bold(-italic)?"', 'style="font-weight: bold"', formula)


def inline_math(writer, node):
    writer.body.append(as_mathml(node, "inline"))
    raise nodes.SkipNode


def displayed_math(writer, node):
    writer.body.append(f'<div class="math">{as_mathml(node, "block")}</div>\n')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", (inline_math, None), (displayed_math, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
