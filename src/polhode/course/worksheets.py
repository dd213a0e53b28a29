"""Worksheets to print and the keys to them: the exercises of a chapter with the numbers of a seed, as one HTML page."""

from __future__ import annotations

import html

from polhode._base import check
from polhode.course.exercises import TIERS, Chapter, Question, read_chapter
from polhode.course.responses import wanted_digits

STYLE = (
    "body{max-width:46rem;margin:2rem auto;padding:0 1rem;font:11pt/1.5 serif}h1{font-size:1.5em}"
    "h2{font-size:1.15em;margin-top:1.6em}li{margin:0 0 1em;break-inside:avoid}.answer{margin:.4em 0 0}"
    ".blank{display:inline-block;width:9em;border-bottom:1px solid}.name{display:flex;gap:2em}"
    ".solution{margin:.3em 0 0;padding-left:.8em;border-left:2px solid #888}"
    "@media print{body{margin:0;max-width:none}a{color:inherit}}"
)


def worksheet(chapter: str, seed: int = 0, *, key: bool = False) -> str:
    """Return a worksheet as an HTML page that prints well.

    Args:
        chapter: its name; ``chapter_names`` lists them.
        seed: which numbers, not negative.
        key: the teacher's key, with answers, solutions and what typical mistakes give.

    Raises:
        InvalidInput: for an unknown chapter, or a seed that is not a whole number from 0.

    >>> "teacher" in worksheet("two-surfaces", key=True)
    True
    """
    seed = check.whole("seed", seed, 0)
    data = read_chapter(chapter)
    title = f"{data.title}: {'teacher’s key' if key else 'worksheet'}"
    head = "" if key else '<p class="name"><span>Name <span class="blank"></span></span></p>'
    tiers = "".join(_tier(data, tier, seed, key=key) for tier in TIERS)
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
        f"<style>{STYLE}</style></head><body>\n<h1>{html.escape(title)}</h1>\n{head}\n{tiers}"
        f"<p><small>Numbers of seed {seed}. Made by polhode.</small></p>\n</body></html>\n"
    )


def _tier(data: Chapter, tier: str, seed: int, *, key: bool) -> str:
    items = []
    for one in data.choices:
        if one.tier == tier:
            options = "".join(
                f"<li>{html.escape(option.text)}" + (
                    f" <b>{'Right' if option.right else 'Wrong'}.</b> {html.escape(option.response)}" if key else ""
                ) + "</li>"
                for option in one.options
            )
            items.append(f'<li>{html.escape(one.text)}<ol type="a">{options}</ol></li>')
    items += [_question(one.draw(seed), key=key) for one in data.exercises if one.tier == tier]
    return f"<h2>{tier.capitalize()}</h2>\n<ol>{''.join(items)}</ol>\n" if items else ""


def _question(question: Question, *, key: bool) -> str:
    unit = html.escape(question.unit)
    text = f"<li>{html.escape(question.text)}"
    if not key:
        digits = wanted_digits(question.tolerance)
        return f'{text}<p class="answer">Answer: <span class="blank"></span> {unit} ({digits} digits)</p></li>'
    mistakes = "".join(f"<li>{value:.4g} {unit}: {html.escape(hint)}</li>" for value, hint in question.mistakes)
    return (
        f'{text}<p class="answer"><b>{question.answer:.5g} {unit}</b> (within {100 * question.tolerance:.2g} %)</p>'
        f'<p class="solution">{html.escape(question.solution)}</p>'
        + (f"<p>Mistakes that the course recognises:</p><ul>{mistakes}</ul>" if mistakes else "") + "</li>"
    )
