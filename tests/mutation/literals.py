"""The literals of the exporter and the shader: how each is changed, and which are left out by which rule.

A literal is

  - a number, or `true` or `false`: a whole number grows by one, another by a quarter, a truth is turned over;
  - a number in a text that the exporter writes, changed in the same way;
  - a text of the exporter's without numbers: its first word is misspelt.

Left out are only kinds that no picture depends on; `RULES` gives each with its reason. What is no code (comments,
#include lines, single characters) is no literal.
"""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
WRITER = ["reference/pov/*.cpp", "reference/pov/*.h"]
SHADER = ["tracer/recursion/whitted.h", "tracer/recursion/opaque.h", "tracer/shading/lighting.h", "tracer/shading/optics.h", "tracer/shading/light_sample.h",
          "tracer/shading/shadow.h", "tracer/intersect/media.h", "tracer/shading/surface.h", "tracer/shading/texture_color.h", "tracer/rays/camera.h",
          "tracer/textures/*.h", "tracer/textures/*.cpp"]
# Files that no picture depends on, and why.
OTHER_FILES = {
    "differences": "finds and names what the reader should be warned of, and writes no line of the scene",
    "coincidence": "the same",
    "export": "the same",
    "header": "comments alone",
    "window": "chooses the power of ten that lengths are multiplied by: its neighbours give the same picture",
    "choices": "numbers that may be any within wide bounds, each with its bounds",
}

RULES = {
    "message": "words for people and the conditions for them: refusals, approximations, errors, assertions",
    "comment": "comments in the .pov",
    "name": "what makes up the names of declared things and files, used as they are declared",
    "layout": "how the .pov is broken into lines (class Text): POV-Ray reads all white space alike",
    "refused": "what only `phong_transmission` does, which POV-Ray has no word for: unit tests check it",
    "rounding": "how many roundings a bound covers: gamma<Real>(n). A wider bound decides nothing else",
    "weight": "the weight that a branch begins with, for `min_contribution`: `validate` follows every branch",
    "explain": "what is noted for `explain` to name the kinds of edges by",
    "extent": "template arguments: another size of an array does not compile, or leaves room that nobody uses",
}

TOKEN = re.compile(r'''
    (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|'(?:\\.|[^'\\])+')
  | (?P<text>"(?:\\.|[^"\\])*")
  | (?P<word>[A-Za-z_]\w*)
  | (?P<number>(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(?P<suffix>[uUlLfF]*))
  | (?P<mark>[;{}()])
''', re.VERBOSE | re.MULTILINE | re.DOTALL)
MESSAGE = re.compile(r"\b(static_assert|assert|refuse|approximate|FileError|SceneError)\s*$")
COMMENT = re.compile(r"\bcomment\s*$")
LAYOUT = re.compile(r"\bText::\w+\s*$")
ROUNDING = re.compile(r"\bgamma<\w+>\s*$")
NUMBER_IN_TEXT = re.compile(r"(?<![\w{.])\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w}])")


class Literal:
    """One change of one literal: `old` at offset `begin` of `file` becomes `new`."""

    def __init__(self, file, begin, line, old, new, rule):
        self.file, self.begin, self.line, self.old, self.new, self.rule = file, begin, line, old, new, rule

    def __str__(self):
        return f"{self.file}:{self.line}: {self.old} -> {self.new}"


def changed_number(text, suffix=""):
    digits = text[:len(text) - len(suffix)]
    if digits.lower().startswith("0x"):
        return hex(int(digits, 16) + 1) + suffix
    if re.fullmatch(r"\d+", digits):
        return str(int(digits) + 1) + suffix
    value = float(digits)
    return repr(value * 1.25 if value else 1.0) + suffix


def changed_texts(text):
    written = text.split("//")[0]
    numbers = [text[:found.start()] + changed_number(found.group()) + text[found.end():]
               for found in NUMBER_IN_TEXT.finditer(written)]
    word = re.search(r"(?<![{\\\w])[A-Za-z_]{2,}", written)
    return numbers or ([text[:word.end()] + "x" + text[word.end():]] if word else [])


def changes(token, in_writer):
    if token["number"]:
        return [changed_number(token[0], token["suffix"])]
    if token["word"] in ("true", "false"):
        return ["false" if token[0] == "true" else "true"]
    if token["text"] and in_writer:
        return changed_texts(token[0])
    return []


class Place:
    """Where a token stands: the calls and functions around it, and its statement."""

    def __init__(self, source):
        self.source = source
        self.tokens = [t for t in TOKEN.finditer(source) if not t["skip"]]
        self.ends = [t.start() for t in self.tokens if t["mark"] and t["mark"] in ";{}"] + [len(source)]
        self.calls = []  # the text before each open parenthesis
        self.bodies = []  # the text before each open brace
        self.head = ""  # the text before the last closed parenthesis
        self.begin = 0  # of the statement
        self.texts = ""  # of the statement, so far

    def step(self, token):
        before = self.source[max(0, token.start() - 60):token.start()]
        if token["mark"] == "(":
            self.calls.append(before)
        elif token["mark"] == ")":
            self.head = self.calls.pop() if self.calls else ""
        elif token["mark"]:
            if token["mark"] == "{":
                self.bodies.append(self.head)
            elif token["mark"] == "}" and self.bodies:
                self.bodies.pop()
            self.begin, self.texts, self.head = token.end(), "", "" if token["mark"] != "{" else self.head
        elif token["text"]:
            self.texts += token[0]

    def statement(self, token):
        return self.source[self.begin:next(end for end in self.ends if end >= token.end())]

    def rule(self, token):
        """The rule by which the literal is left out, or None."""
        statement = self.statement(token)
        line_begin = self.source.rfind("\n", 0, token.start()) + 1
        before, after = self.source[line_begin:token.start()], self.source[token.end():token.end() + 8]
        if any(MESSAGE.search(call) for call in self.calls) or re.search(r"\b(refuse|approximate)\(", statement):
            return "message"
        if "//" in self.texts or token[0].startswith('"//') or any(COMMENT.search(body) for body in self.bodies):
            return "comment"
        if re.search(r"\bname\s*\+?=[^=]", statement):
            return "name"
        if any(LAYOUT.search(body) for body in self.bodies):
            return "layout"
        if re.search(r"\bReal weight = ", statement):
            return "weight"
        if "phong_transmission" in statement:
            return "refused"
        if any(ROUNDING.search(call) for call in self.calls):
            return "rounding"
        if re.search(r"\bnote\(|\bwitness\b", statement):
            return "explain"
        if re.search(r"[<,]\s*$", before) and re.match(r"\s*>", after):
            return "extent"
        return None


def literals_of(file):
    source = (ROOT / file).read_text()
    place = Place(source)
    other = pathlib.Path(file).stem if pathlib.Path(file).stem in OTHER_FILES else None
    for token in place.tokens:
        for new in changes(token, file.startswith("reference/")):
            line = source.count("\n", 0, token.start()) + 1
            yield Literal(file, token.start(), line, token[0], new, other or place.rule(token))
        place.step(token)


def all_literals():
    files = sorted({str(path.relative_to(ROOT)) for pattern in WRITER + SHADER for path in ROOT.glob(pattern)})
    return [literal for file in files for literal in literals_of(file)]
