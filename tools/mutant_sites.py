# SPDX-License-Identifier: Apache-2.0
"""Places of a C++ source where a small fault can be planted, and the fault of each: what tools/mutants plants.

A fault changes one line. Comments, strings, preprocessor lines, assertions and declarations are left alone: a fault there
changes nothing, or does not compile.
"""
import dataclasses
import re


@dataclasses.dataclass(frozen=True)
class Fault:
    """One changed line."""
    file: str
    line: int  # from 1
    kind: str
    before: str
    begin: int  # the part that changes
    end: int
    instead: str

    @property
    def after(self):
        return self.before[:self.begin] + self.instead + self.before[self.end:]

    def __str__(self):
        return f"{self.file}:{self.line}: {self.kind}: {self.before.strip()} -> {self.after.strip() or '(nothing)'}"


def code_only(text):
    """The text with comments, strings and characters blanked out, of the same length and lines."""
    out = list(text)

    def blank(begin, end):
        for i in range(begin, end):
            if out[i] != "\n":
                out[i] = " "

    pattern = re.compile(
        r'//[^\n]*|/\*.*?\*/|R"([^()\\ ]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
    at = 0
    while match := pattern.search(text, at):
        begin, end = match.span()
        at = end
        # 1'000 is a number.
        if match.group().startswith("'") and begin > 0 and text[begin - 1].isdigit() and re.match(r"'[0-9A-Fa-f]", match.group()):
            at = begin + 1
            continue
        blank(begin, end)
    return "".join(out)


# The other side of the bound, and the opposite.
COMPARISONS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
# A line that has to do with whole numbers: there the bound itself is a value.
COUNTED = re.compile(r"(?<![\w.'])\d+(?![\w.'])|size\(\)|count|index|\b(int|i|j|k|n|row|column|day|days|stroke)\b")
SKIPPED_LINE = re.compile(r"^\s*(#|using\b|namespace\b|template\b|static_assert\b|assert\(|public:|private:|protected:|friend\b|struct\b|"
                          r"class\b|enum\b|extern\b|typedef\b)")
DECLARATION = re.compile(r"^\s*(?:(?:const|constexpr|static|auto|double|float|int|bool|std::\w+|[A-Z]\w*(?:::\w+)*)(?:<[^;]*>)?[\s&*]+)+\w+\s*(?:[=;{(\[]|$)")
STATEMENT = re.compile(r"^\s*(?:\(void\))?[\w:\->.\[\]*]+\s*(?:\(.*\)|(?:[-+*/|&]?=(?!=)|<<).*|\+\+|--)\s*;\s*$")


def faults_of(file, text):
    """Every fault that can be planted in one file, in its order."""
    lines = text.split("\n")
    bares = code_only(text).split("\n")
    found = []
    for number, (line, bare) in enumerate(zip(lines, bares), 1):
        # What a member begins with is mostly overwritten before anybody reads it.
        if file.endswith(".h") and re.match(r"\s*(?:mutable )?[\w:<>, *]+ \w+_(?:\{.*\}| = .*);", bare):
            continue
        if not bare.strip() or SKIPPED_LINE.match(bare) or "static_assert" in bare or "kTr" in bare:
            continue
        # Memory asked for in advance changes only how long it takes.
        if re.match(r"\s*[\w.\->\[\]]+\breserve\(.*\);", bare):
            continue

        def plant(kind, begin, end, instead):
            found.append(Fault(file, number, kind, line, begin, end, instead))

        is_template = re.search(r"\b(template|static_cast|const_cast|reinterpret_cast|vector|span|optional|function|Result|array|map|"
                                r"unique_ptr|shared_ptr|pair|tuple|numeric_limits|include|Point2|make_unique|make_shared|"
                                r"operator|get|duration_cast|floor|ceil|lock_guard|atomic)\s*<", bare)
        for match in re.finditer(r"(?<=[\w)\]] )(<=|>=|==|!=|<|>)(?= [\w(\-!:*&])", bare):
            if match.group() in "<>" and is_template and bare.count("<") > 1:
                continue
            for instead in COMPARISONS[match.group()]:
                # For a quantity that may have any value the bound itself changes nothing.
                if instead[0] == match.group()[0] in "<>" and not COUNTED.search(bare):
                    continue
                plant("comparison", match.start(), match.end(), instead)
        for match in re.finditer(r"(?<=[\w)\]] )([-+])(?= [\w(])", bare):
            plant("sign", match.start(), match.end(), "-" if match.group() == "+" else "+")
        for match in re.finditer(r"(?:(?<=[,=?:{] )|(?<=return )|(?<=\())-(?=[\w(])", bare):
            plant("sign", match.start(), match.end(), "")
        for match in re.finditer(r"(?<![\w.'])(\d+)(?![\w.'])", bare):
            if bare[:match.start()].rstrip().endswith("<") and is_template:
                continue
            # The exponent of a constant, which is one number.
            if re.search(r"\d\.?e[-+]$", bare[:match.start()]):
                continue
            # One element more than an array is given is zero, and nobody asks for it.
            if re.search(r"\barray<[^<>]*, $", bare[:match.start()]):
                continue
            value = int(match.group())
            # A physical quantity written without a fraction.
            if value > 2 and re.search(r"\b(double|float)\b", bare[:match.start()]):
                plant("constant", match.start(), match.end(), f"{value * 1.4:.6g}")
            elif value > 0 and bare[:match.start()].endswith("[") and bare.startswith("]", match.end()):
                # The element after the last is none: what a program does with it nobody can say.
                plant("off by one", match.start(), match.end(), str(value - 1))
            else:
                plant("off by one", match.start(), match.end(), str(value + 1))
        for match in re.finditer(r"(?<![\w.'])(\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+|\d{1,3}(?:'\d{3})+)(F?)(?![\w.'])", bare):
            value = float(match.group(1).replace("'", ""))
            if value == 0:
                instead = "1.0"
            elif "'" in match.group(1):
                instead = str(int(value * 1.4))
            else:
                instead = f"{value * 1.4:.6g}"
                instead += "" if re.search(r"[.e]", instead) else ".0"
            plant("constant", match.start(), match.end(), instead + match.group(2))
        for match in re.finditer(r" (&&|\|\|) ", bare):
            # The left side alone, up to the end of what stands in these brackets or on this line.
            depth, end = 0, match.end()
            while end < len(bare):
                if bare[end] in "([{":
                    depth += 1
                elif bare[end] in ")]}":
                    if depth == 0:
                        break
                    depth -= 1
                elif depth == 0 and (bare[end] in ";?," or bare.startswith(" &&", end) or bare.startswith(" ||", end)):
                    break
                end += 1
            if end < len(bare):
                plant("dropped check", match.start(), end, "")
        if match := re.match(r"^(\s*)(?:\} else )?if \(", bare):
            closing = matching(bare, bare.index("("))
            if closing is not None and not re.search(r"\bif \((?:const )?(?:auto|[\w:<>]+)[&* ]+\w+ =", bare):
                begin = bare.index("(") + 1
                if not re.search(r";", bare[begin:closing]):
                    plant("dropped check", begin, closing, "false")
        if STATEMENT.match(bare) and not DECLARATION.match(bare) and not re.match(r"^\s*(return|break|continue|throw|case|else|delete)\b", bare):
            previous = bares[number - 2].rstrip() if number > 1 else ""
            if previous.endswith((";", "{", "}", ":")) or not previous.strip():
                begin = len(line) - len(line.lstrip())
                plant("dropped statement", begin, len(line), "")
                if not bare.lstrip().startswith("("):
                    plant("early return", begin, begin, "return; ")
        for match in re.finditer(r"\b(?!(?:if|for|while|switch|return|min|max|minmax|clamp|dot|distance|hypot|fma|angle_between|swap)\b)\w+\((\w+(?:\.\w+)*), (\w+(?:\.\w+)*)(?=[,)])", bare):
            a, b = match.group(1), match.group(2)
            if a != b and not (a.isdigit() and b.isdigit()):
                plant("swapped arguments", match.start(1), match.end(2), f"{b}, {a}")
    return found


def matching(text, at):
    """Where the bracket that opens at `at` closes; None: not in this text."""
    depth = 0
    for i in range(at, len(text)):
        if text[i] in "([{":
            depth += 1
        elif text[i] in ")]}":
            depth -= 1
            if depth == 0:
                return i
    return None
