"""The texts that a page can show, collected from its sources: scripts, template, stories, and what Python writes."""

import ast
import re
import tomllib
from html.parser import HTMLParser
from pathlib import Path

ROOT = Path(__file__).parents[2]
WORDS = ROOT / "viewer" / "words"
TEMPLATE = ROOT / "src" / "polhode" / "viewer" / "assets" / "template.html"
STORIES = ROOT / "src" / "polhode" / "viewer" / "playground.toml"
NAMES = ("aria-label", "title", "alt")
"""Attributes with words."""
SHOWN = ("title", "words", "text", "label", "legend", "shape", "unit", "name", "say")
"""Keys whose values are shown."""
WORD = re.compile(r"[A-Za-z]{2}")
PROSE = re.compile(r"[A-Za-z|₃'’]{2,}[,:;.]? +(?:[A-Za-z(|→{]|[^\W\d_])")
"""Two words in a row."""
SYMBOLS = re.compile(
    r"^(?:kg|m|s|N|g|mm|km|cm|nm|rad|deg|mas|Pa|W|J|MB|cm⁻¹|log₁₀|mgl|mg|τ|px|ns|us|ms|min|fs|ps|µm|µs"
    r"|[°²³·/^()\[\]×*−⁻¹ |LΩθ̇.]|\d)+$"
)
"""Units and signs are alike in all languages."""
NOT_SHOWN = (
    (r"^(?:600 |12px )|system-ui", "a font"),
    (r"^(?:input|script|\[|#presets|a, |button, |all )|, (?:select|summary)", "a selector"),
    (r"^\s*\[|kind = |until = |^# a body|^angular_velocity|^mass = |kg\*m|N\*m|attitude = |law = |moment = |moments = ",
     "a spec"),
    (r"<iframe|width:100%|allow-|transparent|linear-gradient|^rgb\(|^sha256|video/webm|^\(prefers", "HTML or CSS"),
    (r"^abc$|^EN$|_rate$|^momentum$|^velocity$|^(?:space|body|axis) cone$", "a name that stands for something"),
    (r"^a number, |numbers (?:in a list|between commas), each|^zero or of a size from|^a word$",
     "part of an error of `set`, which programs read"),
    (r"^(?:deg|rad) s\^?-1$|^seconds_elapsed$|^time since start in ms$|^Sensor Logger", "an app's unit or header"),
    (r"^(?:gyroscope|accelerometer|acceleration) \{\}$", "an app's header"),
    (r"^wide$|^words$|^legend$|^plot$|^plain$|^heading$|^control choice$|^panel flat$", "a class"),
)  # fmt: skip


class Literal:
    """A text in a script: its line, what stands before it, and whether values are put into it."""

    def __init__(self, text, before, filled):
        self.text, self.before, self.filled = text, before, filled


def literals(source):
    """Return the texts in a script, those inside of `${...}` too."""
    found, place, last = [], 0, ""
    while place < len(source):
        sign = source[place]
        if source.startswith("//", place):
            place = source.find("\n", place) if "\n" in source[place:] else len(source)
        elif source.startswith("/*", place):
            place = source.index("*/", place) + 2
        elif sign == "/" and (last in "(,=:[!&|?{};>" or source[:place].rstrip().endswith("return")):
            place = _after_pattern(source, place)
            last = "/"
        elif sign in "\"'":
            end = _end_of_string(source, place)
            found.append(Literal(_unescaped(source[place + 1 : end]), source[max(0, place - 60) : place], False))
            place, last = end + 1, '"'
        elif sign == "`":
            place = _template(source, place, found)
            last = "`"
        else:
            last = last if sign.isspace() else sign
            place += 1
    return found


def _after_pattern(source, place):
    inside = False
    place += 1
    while inside or source[place] != "/":
        if source[place] == "\\":
            place += 1
        elif source[place] in "[]":
            inside = source[place] == "["
        place += 1
    return place + 1


def _end_of_string(source, place):
    end = place + 1
    while source[end] != source[place]:
        end += 2 if source[end] == "\\" else 1
    return end


def _template(source, place, found):
    before, parts = source[max(0, place - 60) : place], []
    place += 1
    while source[place] != "`":
        if source[place] == "\\":
            parts.append(source[place : place + 2])
            place += 2
        elif source.startswith("${", place):
            end = _end_of_value(source, place + 2)
            found.extend(literals(source[place + 2 : end]))
            parts.append("\0")
            place = end + 1
        else:
            parts.append(source[place])
            place += 1
    text = "".join(parts)
    found.append(Literal(_unescaped(text).replace("\0", " | "), before, "\0" in text))
    return place + 1


def _end_of_value(source, place):
    depth = 0
    while depth or source[place] != "}":
        if source[place] == "`":
            place = _template(source, place, [])
            continue
        if source[place] in "\"'":
            place = _end_of_string(source, place)
        depth += {"{": 1, "}": -1}.get(source[place], 0)
        place += 1
    return place


def _unescaped(text):
    text = re.sub(r"\\u([0-9a-fA-F]{4})", lambda found: chr(int(found[1], 16)), text)
    return text.replace('\\"', '"').replace("\\'", "'").replace("\\n", "\n").replace("\\`", "`")


def scripts():
    """Return the page's scripts, and those that kinds bring."""
    own = sorted((ROOT / "viewer" / "src").rglob("*.js"))
    return {path: path.read_text("utf-8") for path in [*own, *sorted((ROOT / "src/polhode").rglob("panel.js"))]}


def is_shown(one):
    """Whether a text of a script is shown, by its own looks or by what it stands in."""
    text, before = one.text, one.before
    if re.search(r"(?:RangeError|TypeError|Error)\(\s*$", before) or SYMBOLS.match(text) or not WORD.search(text):
        return False
    if any(re.search(pattern, text) for pattern, _ in NOT_SHOWN):
        return False
    if one.filled:
        return bool(re.search(r"[A-Za-z]{2,}[,:;]? [A-Za-z(]|[a-z]{3,} \||\| +[a-z]{3,} ", text))
    said = re.search(r"\bsay\((?:[\w.!]+ \? (?:\"[^\"]*\" : )?)?$|this\.say\($|refuse\($", before)
    valued = re.search(rf"(?:\b(?:{'|'.join(SHOWN)}): |(?:push\(|\[)\[)$", before) and not before.endswith(" name: ")
    return bool(said or valued or PROSE.search(text))


def texts_of_scripts(sources):
    """Return the texts by what shows them: those that `say` can find, and those with values put in without it."""
    found, loose = set(), set()
    for path, source in sources.items():
        for one in literals(source):
            if is_shown(one):
                (loose if one.filled else found).add((one.text, path.name))
    return found, loose


class _Template(HTMLParser):
    def __init__(self):
        super().__init__()
        self.found, self.inside = set(), []

    def handle_starttag(self, tag, attrs):
        if tag not in ("meta", "input", "img", "path", "circle"):
            self.inside.append(tag)
        self.found |= {value for name, value in attrs if name in NAMES and value and WORD.search(value)}

    def handle_endtag(self, tag):
        if tag in self.inside:
            del self.inside[len(self.inside) - 1 - self.inside[::-1].index(tag) :]

    def handle_data(self, data):
        hidden = {"script", "style", "noscript", "title"} & set(self.inside)
        if not hidden and WORD.search(data) and "@@" not in data:
            self.found.add(data.strip())


def texts_of_template(text):
    parser = _Template()
    parser.feed(text)
    return parser.found


def texts_of_stories(text):
    presets = tomllib.loads(text)["preset"]
    return {one["title"] for one in presets} | {step["say"] for one in presets for step in one["story"]}


PYTHON = [ROOT / "src/polhode/viewer/panels.py", ROOT / "src/polhode/viewer/shapes.py",
          *sorted((ROOT / "src/polhode").glob("*/*/panel.py"))]  # fmt: skip


def texts_of_python(sources):
    """Return the texts under keys that are shown, or in the pairs of a name and a value, of what Python writes."""
    found = set()
    for source in sources:
        for node in ast.walk(ast.parse(source)):
            shown = []
            if isinstance(node, ast.Dict):
                keys = [key.value if isinstance(key, ast.Constant) else None for key in node.keys]
                shown = [value for key, value in zip(keys, node.values, strict=True) if key in SHOWN]
            elif isinstance(node, ast.List | ast.Tuple) and len(node.elts) == 2:
                shown = node.elts[:1] if isinstance(node, ast.List) else node.elts[1:]
                shown = [one for one in shown if not isinstance(one, ast.Tuple)]
            elif isinstance(node, ast.Assign) and any(getattr(t, "id", "") == "words" for t in node.targets):
                shown = [node.value]
            found = found.union(*map(_texts_of_node, shown))
    return {text for text in found if PROSE.search(text) or re.fullmatch(r"[a-z]{4,}|[A-Z][a-z]{3,}", text)}


def _texts_of_node(node):
    """Return the texts that an expression may be: of a text with values the text, of one put together its pieces."""
    if isinstance(node, ast.Constant):
        return {node.value} if isinstance(node.value, str) else set()
    if isinstance(node, ast.IfExp):
        return _texts_of_node(node.body) | _texts_of_node(node.orelse)
    if isinstance(node, ast.List) and node.elts:
        return _texts_of_node(node.elts[0])
    if isinstance(node, ast.Tuple):
        return set().union(*map(_texts_of_node, node.elts))
    if isinstance(node, ast.JoinedStr):
        return {" | ".join(str(part.value) for part in node.values if isinstance(part, ast.Constant))}
    return set()


def python_sources():
    return [path.read_text("utf-8") for path in PYTHON]
