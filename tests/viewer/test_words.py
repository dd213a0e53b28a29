"""The page's words in other languages: every text has its translation, which says the same, and the page speaks it."""

import json
import re
from itertools import chain

import pytest

from polhode.kinds.playground import presets
from viewer.page_words import (
    NAMES,
    ROOT,
    STORIES,
    SYMBOLS,
    TEMPLATE,
    WORDS,
    literals,
    python_sources,
    scripts,
    texts_of_python,
    texts_of_scripts,
    texts_of_stories,
    texts_of_template,
)
from viewer.playgrounds import quick

LANGUAGES = sorted(path.stem for path in WORDS.glob("*.json"))
QUANTITIES = {"vertical momentum", "axial momentum"}
"""Names of what a motion conserves, which Python writes with underscores."""
ASSEMBLED = {"polhode: a playground"}
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
NUMBER = re.compile(r"(?<![A-Za-z\d])\d+(?:[.,]\d+)?")


def words(language):
    return json.loads((WORDS / f"{language}.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def shown():
    """What the page can show: every text, and those that are put together without `say`."""
    said, loose = texts_of_scripts(scripts())
    template, stories = TEMPLATE.read_text("utf-8"), STORIES.read_text("utf-8")
    other = texts_of_template(template) | texts_of_stories(stories) | texts_of_python(python_sources())
    return {text for text, _ in said} | other - {"EN"}, loose


@pytest.fixture(scope="module")
def written(shown):
    """Every text that stands in a source, shown or not."""
    more = [path.read_text("utf-8") for path in (ROOT / "reference").glob("*.js")]
    found = {one.text for source in chain(scripts().values(), more) for one in literals(source)}
    python = "\n".join(python_sources())
    return lambda text: text in found or text in shown[0] or f'"{text}"' in python or text in QUANTITIES | ASSEMBLED


# ---------------------------------------------------------------- the files


def missing(texts, translations):
    return sorted(texts - set(translations))


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_has_its_translation(shown, language):
    assert missing(shown[0], words(language)) == []
    assert all(words(language).values())


def test_a_text_without_translation_is_found():
    source = 'const found = [["what it does", say("spins {times} times", { times })], [`nods`, "hangs"]];'
    said, _ = texts_of_scripts({ROOT / "new.js": source + ' panel.legend = [{ text: "glow", color }];'})
    assert missing({text for text, _ in said}, words("de")) == ["glow", "spins {times} times"]
    assert texts_of_template('<button title="Undo it">Redo</button><script>no words</script>') == {"Undo it", "Redo"}
    assert missing(texts_of_python(['panel = {"title": "Shadow of L", "rows": 3}']), words("fr")) == ["Shadow of L"]


def test_no_text_is_put_together_without_its_translation(shown):
    assert shown[1] == set()
    _, loose = texts_of_scripts({ROOT / "new.js": "return `turns over ${count} times`;"})
    assert loose


def unused(translations, written):
    return [text for text in translations if not written(text)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_translation_is_of_a_text_that_is_gone(written, language):
    assert unused(words(language), written) == []
    assert unused({"Show the shadow": "Schatten zeigen"}, written) == ["Show the shadow"]


def test_languages_hold_the_same_texts_in_the_same_order():
    assert LANGUAGES == ["de", "es", "fr"]
    assert len({tuple(words(language)) for language in LANGUAGES}) == 1


def disagreements(translations):
    """Return what a translation has otherwise than its text: values that are put in, brackets, numbers."""
    found = []
    for text, translation in translations.items():
        for what, parts in (
            ("values", lambda said: sorted(re.findall(r"\{\w+\}", said))),
            ("brackets", lambda said: [len(re.findall(sign, said)) for sign in (r"\[", r"\]", r"\[[^\]]+\]")]),
            ("numbers", lambda said: sorted(number.replace(",", ".") for number in NUMBER.findall(said))),
        ):
            if parts(text) != parts(translation):
                found.append((what, text))
    return found


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_says_the_same(language):
    assert disagreements(words(language)) == []


@pytest.mark.parametrize(("text", "translation", "what"), [
    ("edge along axis {axis}", "Kante entlang der Achse", "values"),
    ("[Let go], it falls.", "Losgelassen fällt er.", "brackets"),
    ("within 3.5° of L", "höchstens 3,6° von L", "numbers"),
])  # fmt: skip
def test_a_translation_that_says_something_else_is_found(text, translation, what):
    assert disagreements({text: translation}) == [(what, text)]


# ---------------------------------------------------------------- the page


POWER = r"[\d.,]+(?:e[+-]\d+)?(?:·10)?[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*|[GMk]?Hz|[\[\];:,()]"
"""Numbers with their powers of ten, frequencies, and signs between."""

LOOK = """names => {
  const found = [], texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = texts.nextNode(); node; node = texts.nextNode())
    if (!node.parentElement.closest("script, style, noscript, #summary, #notes, .language")) found.push(node.data);
  for (const one of document.querySelectorAll("*")) for (const name of [...names, "aria-valuetext"])
    found.push(one.getAttribute(name) ?? "");
  return found;
}"""
"""What Python says of a motion in sentences, `summary` and `notes`, stays English."""


def marked(text):
    """Return a text as a language that marks all its words would say it, with a story's button in its brackets."""
    return "⟦" + re.sub(r"\[([^\]]{3,})\]", r"⟧[⟦\1⟧]⟦", text) + "⟧"


def english_of(texts):
    """Return the texts with words outside of marks; numbers and units are alike everywhere."""
    found = set()
    for text in texts:
        rest, depth = "", 0
        for sign in text:
            depth += {"⟦": 1, "⟧": -1}.get(sign, 0)
            rest += sign if depth == 0 and sign != "⟧" else ""
        bare = re.sub(POWER, " ", rest).strip()
        if re.search(r"[A-Za-z]{2}", bare) and not SYMBOLS.match(bare):
            found.add(text.strip())
    return found


def check_all_said(page):
    for button in page.tab.locator("#presets button").all():
        button.click()
        page.unfold()
        for step in [None, *page.tab.locator("#story button").all()]:
            if step:
                step.click()
            assert english_of(page.tab.evaluate(LOOK, list(NAMES))) == set()
    page.tab.locator("#film-length").fill("0")
    page.tab.keyboard.press("Enter")
    assert english_of(page.tab.evaluate(LOOK, list(NAMES))) == set()
    assert not page.complaints


def speaking(opened, path, table, **options):
    """Open a page that is brought a language called xx."""
    return opened(path, "#lang=xx", script=f"globalThis.polhodeWords = {json.dumps({'xx': table})}", **options)


@pytest.mark.browser
def test_everything_that_is_shown_is_said(short, opened):
    """In a language that marks its words, nothing stays without a mark."""
    page = speaking(opened, short, {text: marked(text) for text in words("de")})
    check_all_said(page)
    page.tab.evaluate("document.querySelector('#share').append('Undo it')")
    with pytest.raises(AssertionError, match="Undo it"):
        check_all_said(page)


@pytest.mark.browser
@pytest.mark.sweep
def test_everything_in_the_whole_playground_is_said(whole, opened):
    check_all_said(speaking(opened, whole, {text: marked(text) for text in words("de")}))


@pytest.mark.browser
def test_what_has_no_translation_stays_english(short, opened):
    page = speaking(opened, short, {"T-handle": "te"})
    assert page.tab.locator("#presets button").all_text_contents()[:2] == ["te", "Book"]
    assert page.tab.locator("h1").text_content() == "te"
    assert page.tab.locator("#play").get_attribute("aria-label") == "Play"


def check_language(page, language, used):
    table = words(language)
    assert page.tab.evaluate("document.documentElement.lang") == language
    for k, preset in enumerate(used):
        page.tab.locator("#presets button").nth(k).click()
        page.unfold()
        assert page.tab.locator("h1").text_content() == table[preset["title"]]
        said = page.tab.locator("#story li").all_text_contents()
        assert said == [re.sub(r"[\[\]]", "", table[step["say"]]) for step in preset["story"]]
        for step, button in zip(preset["story"], page.tab.locator("#story button").all_text_contents(), strict=True):
            assert f"[{button}]" in table[step["say"]]
        for name in ("link", "picture", "film", "reset"):
            (english,) = re.findall(rf'id="{name}"[^>]*>([^<]+)<', TEMPLATE.read_text("utf-8"))
            assert page.tab.locator(f"#{name}").text_content() == table[english]
        assert page.tab.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert not page.complaints


@pytest.mark.browser
@pytest.mark.parametrize(("options", "language"), [
    # on a phone the longest words tell whether there is room; the sweep has each language on the smallest screen
    pytest.param(PHONE, "de", id="phone-de"), pytest.param({}, "fr", id="desktop-fr"),
    *(pytest.param(PHONE, x, id=f"phone-{x}", marks=pytest.mark.sweep) for x in ("es", "fr")),
    *(pytest.param({}, x, id=f"desktop-{x}", marks=pytest.mark.sweep) for x in ("de", "es")),
])  # fmt: skip
def test_the_page_speaks_the_language_of_its_address(short, opened, language, options):
    page = opened(short, **options)
    page.tab.goto(f"{short.as_uri()}#lang={language}")
    page.until(f"document.documentElement.lang === '{language}'")
    check_language(page, language, quick())
    page.picture(f"words-{language}-{options.get('viewport', {}).get('width', 1280)}")
    page.tab.evaluate("document.querySelector('#link').textContent = 'Copy link'")
    with pytest.raises(AssertionError):
        check_language(page, language, presets()[:1])


@pytest.mark.browser
@pytest.mark.sweep
@pytest.mark.parametrize("language", LANGUAGES)
def test_the_whole_playground_speaks(whole, opened, language):
    page = opened(whole, **PHONE)
    page.tab.goto(f"{whole.as_uri()}#lang={language}")
    page.until(f"document.documentElement.lang === '{language}'")
    check_language(page, language, presets())


@pytest.mark.browser
def test_a_language_is_chosen_by_keys_and_kept_in_the_address(short, opened):
    page = opened(short)
    page.tab.locator("#presets button").nth(1).click()
    page.tab.evaluate("window.polhode.set({ spin: { rate: 9 } })")
    page.tab.evaluate("window.polhode.goTo(0.25)")
    before = page.tab.evaluate("window.polhode.state(0.5)")
    page.tab.locator("#language").focus()
    page.tab.keyboard.press("ArrowDown")
    page.until("document.documentElement.lang === 'de'")
    assert page.tab.locator("#language-code").text_content() == "DE"
    page.until("location.hash.startsWith('#lang=de&preset=book') && location.hash.includes('t=0.25')")
    after = page.tab.evaluate("window.polhode.state(0.5)")
    assert after["momentum"] == pytest.approx(before["momentum"], rel=1e-14)
    assert after["attitude"] == pytest.approx(before["attitude"], rel=1e-14)
    assert page.tab.evaluate("document.activeElement.id") == "language"
    page.tab.reload()
    page.until("window.polhode && window.polhode.firstPicture")
    assert page.tab.locator("h1").text_content() == "Buch"
    page.tab.locator("#language").select_option("en")
    assert page.tab.locator("h1").text_content() == "Book"


@pytest.mark.browser
@pytest.mark.parametrize(("locale", "lang", "title"), [
    ("fr-CH", "", "Livre"), ("es-MX", "", "Libro"), ("it-IT", "", "Book"), ("de-DE", "#lang=en", "Book"),
    ("en-US", "#lang=nn", "Book"),
])  # fmt: skip
def test_the_address_goes_before_the_browser(short, opened, locale, lang, title):
    page = opened(short, lang, locale=locale)
    assert page.tab.locator("#presets button").nth(1).text_content() == title
    assert page.tab.evaluate("location.hash") == ("#lang=en&" if lang == "#lang=en" else "#") + "preset=t_handle"


@pytest.mark.browser
def test_numbers_have_a_decimal_comma_and_fields_take_both(short, opened):
    page = opened(short, locale="de-DE")
    field = page.tab.locator("#set-spin-tilt")
    tilts = []
    for typed in ("2,5", "2.5"):
        page.tab.locator("#reset").click()
        field.fill(typed)
        page.tab.keyboard.press("Enter")
        tilts.append(page.tab.evaluate("window.polhode.settings().spin.angular_velocity"))
        page.tab.locator("#set-spin-rate").focus()
        page.tab.keyboard.press("Tab")
        page.tab.keyboard.press("ArrowRight")  # which writes the fields again
        assert field.input_value() == "2,5"
    assert tilts[0] == tilts[1]
    assert re.search(r"\d,\d", page.tab.locator("#now").text_content())
    page.unfold()
    assert not re.search(r"\d\.\d", page.tab.locator("#facts").text_content())
    assert re.search(r"\d\.\d", page.tab.evaluate("window.polhode.spec()"))  # programs read that
    assert not re.search(r"\d,\d", page.tab.evaluate("window.polhode.spec()"))
