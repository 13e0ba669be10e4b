# SPDX-License-Identifier: Apache-2.0
"""Writes many faults into a source at once, each asleep until the environment variable NAZORI_FAULT names it.

So one build serves all of them. A fault that no longer compiles this way (a constant that the compiler must know, say) is
found in the compiler's messages by its line; tools/mutants then builds it alone.
"""
import collections
import re

from mutant_sites import matching

HEADER = r"""// Written by tools/mutants: which of the planted faults is awake, and which were reached.
#pragma once
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <type_traits>
#include <unistd.h>

namespace nazori_planted {

constexpr int kMost = 65536;
inline unsigned char nowhere[kMost];
inline unsigned char* reached = nowhere;
inline int awake = -1;

// Before all other objects: a fault may be in what they begin with.
__attribute__((constructor(101), used)) static void begin() {
  if (awake >= 0) return;
  const char* number = std::getenv("NAZORI_FAULT");
  awake = number ? std::atoi(number) : 0;
  const char* file = std::getenv("NAZORI_FAULT_REACHED");
  const int fd = file ? ::open(file, O_RDWR | O_CLOEXEC) : -1;
  if (fd < 0) return;
  void* map = ::mmap(nullptr, kMost, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (map != MAP_FAILED) reached = static_cast<unsigned char*>(map);
  ::close(fd);
}

inline bool is(int fault) noexcept {
  reached[fault] = 1;
  return awake == fault;
}

enum class Op { lt, le, gt, ge, eq, ne, add, sub };

template <Op O, class A, class B>
auto apply(const A& a, const B& b) {
  if constexpr (O == Op::lt) return a < b;
  else if constexpr (O == Op::le) return a <= b;
  else if constexpr (O == Op::gt) return a > b;
  else if constexpr (O == Op::ge) return a >= b;
  else if constexpr (O == Op::eq) return a == b;
  else if constexpr (O == Op::ne) return a != b;
  else if constexpr (O == Op::add) return a + b;
  else return a - b;
}

// `a < Between<...>{} < b` is a comparison of a and b, whatever stands around it.
template <int K, Op Was, Op Becomes> struct Between {};
template <class A, int K, Op Was, Op Becomes> struct Left { const A& a; };

template <class A, class B, int K, Op Was, Op Becomes>
auto both(const Left<A, K, Was, Becomes>& left, const B& b) {
  static_assert(std::is_same_v<decltype(apply<Was>(left.a, b)), decltype(apply<Becomes>(left.a, b))>);
  if (is(K)) return apply<Becomes>(left.a, b);
  return apply<Was>(left.a, b);
}

template <class A, int K, Op W, Op B> Left<A, K, W, B> operator<(const A& a, Between<K, W, B>) { return {a}; }
template <class A, int K, Op W, Op B> Left<A, K, W, B> operator!=(const A& a, Between<K, W, B>) { return {a}; }
template <class A, int K, Op W, Op B> Left<A, K, W, B> operator+(const A& a, Between<K, W, B>) { return {a}; }
template <class A, class B, int K, Op W, Op C> auto operator<(const Left<A, K, W, C>& left, const B& b) { return both(left, b); }
template <class A, class B, int K, Op W, Op C> auto operator!=(const Left<A, K, W, C>& left, const B& b) { return both(left, b); }
template <class A, class B, int K, Op W, Op C> auto operator+(const Left<A, K, W, C>& left, const B& b) { return both(left, b); }

}  // namespace nazori_planted
"""



def header(warnings):
    """The header of a tree in which warnings are errors: none of them where a fault is."""
    ignored = "\n".join(f'#pragma GCC diagnostic ignored "{warning}"' for warning in ["-Wpragmas", "-Wnarrowing", "-Wvla", *warnings])
    return HEADER.replace("#pragma once\n", f"#pragma once\n{ignored}\n")


OPS = {"<": "lt", "<=": "le", ">": "gt", ">=": "ge", "==": "eq", "!=": "ne", "+": "add", "-": "sub"}


def guarded(fault, number):
    """The line with the fault asleep in it; None where it cannot be written so."""
    line, begin, end = fault.before, fault.begin, fault.end
    was, head, tail = line[begin:end], line[:begin], line[end:]
    awake = f"nazori_planted::is({number})"
    if fault.kind == "early return":
        return f"{head}if ({awake}) return; {tail}"
    if fault.kind == "dropped statement":
        return f"{head}if (!{awake}) {was}{tail}"
    if fault.kind == "dropped check":
        if fault.instead == "false":
            return f"{head}!{awake} && ({was}){tail}"
        sign, right = was.strip()[:2], was.strip()[2:].strip()
        if sign == "||" and tail.startswith(" &&"):
            return None
        return f"{head} && ({awake} || ({right})){tail}" if sign == "&&" else f"{head} || (!{awake} && ({right})){tail}"
    if fault.kind == "swapped arguments":
        a, b = was.split(", ")
        return f"{head}({awake} ? {b} : {a}), ({awake} ? {a} : {b}){tail}"
    if fault.kind == "comparison" or (fault.kind == "sign" and fault.instead):
        joint = "+" if fault.kind == "sign" else "!=" if was in ("==", "!=") else "<"
        between = f"nazori_planted::Between<{number}, nazori_planted::Op::{OPS[was]}, nazori_planted::Op::{OPS[fault.instead]}>{{}}"
        return f"{head}{joint} {between} {joint}{tail}"
    if fault.kind == "sign":
        operand = postfix_expression(tail)
        return operand and f"{head}({awake} ? ({operand}) : -({operand})){tail[len(operand):]}"
    return f"{not_constant(head)}({awake} ? {fault.instead} : {was}){tail}"


def postfix_expression(text):
    """What a sign before `text` belongs to: `a.b(c)[d]` of `a.b(c)[d] * e`. None where the line ends within brackets."""
    at = 0
    while match := re.compile(r"[\w.']+|::|->|[(\[{]").match(text, at):
        if match.group() in "([{":
            closing = matching(text, at)
            if closing is None:
                return None
            at = closing + 1
        else:
            at = match.end()
    return text[:at] or None


def not_constant(head):
    """A constant that depends on the environment is none for the compiler."""
    if not (match := re.match(r"(\s*)((?:inline |static )*)constexpr ", head)):
        return head
    space, words, rest = match.group(1), match.group(2), head[match.end():]
    if re.match(r"[\w:<>,&* ]+\(.*\)[\w ]*\{", rest):
        return f"{space}{words}{'' if 'inline' in words else 'inline '}{rest}"
    if "static" in words:
        return f"{space}static inline const {rest}" if "inline" not in words else f"{space}{words}const {rest}"
    # A lambda need not capture what is static.
    return f"{space}{words or ('static ' if space else '')}const {rest}"


def planted(text, faults, header):
    """The source with faults, {number: fault}, at most one a line."""
    lines = text.split("\n")
    for number, fault in faults.items():
        lines[fault.line - 1] = guarded(fault, number)
    return f'#include "{header}"\n#line 1\n' + "\n".join(lines)


FEW_LINES = 12
PLACE = re.compile(r"^(?:In file included from |\s+from )?([^\s:][^:\n]*):(\d+):(?:\d+:)?(.*)$", re.M)


def blamed(messages, faults):
    """Those of the faults, {number: fault}, that the compiler's messages are about, with whether it wanted a constant there.

    @return {number: bool}. First of all those at whose line an error is; else those at a line that was mentioned; else those
    a few lines below one: an early return within a function that is an argument is told at the call; else those in a file
    that has an error: an early return within a lambda is told at its other returns.
    """
    places = collections.defaultdict(list)
    for number, fault in faults.items():
        places[(fault.file, fault.line)].append(number)
    direct, mentioned, below, in_file = {}, {}, {}, {}
    errors = "\n".join(re.findall(r"^.* error: .*$", messages, re.M))
    wants = re.compile(r"constant expression|constant-expression|constexpr|is not a constant|case label|bit-field|enumerator")
    for match in PLACE.finditer(messages):
        file = re.sub(r"^(?:\.\./)*", "", match.group(1))
        file = next((f for f, _ in places if file == f or file.endswith("/" + f)), file)
        for number, fault in faults.items():
            if fault.file == file and 0 < fault.line - int(match.group(2)) <= FEW_LINES:
                below[number] = bool(wants.search(errors))
            if fault.file == file and " error:" in match.group(3):
                in_file[number] = False
        for number in places.get((file, int(match.group(2))), ()):
            says = match.group(3)
            if " error:" in says:
                direct[number] = direct.get(number, False) or bool(wants.search(says))
            else:
                mentioned[number] = bool(wants.search(errors))
    return direct or mentioned or below or in_file


def behind_constants(messages, faults, text_of):
    """Those of the faults in the default of a member, {number: True}, for which a constant of that type is none any more.

    The compiler names only the line of the constant. text_of gives the source of a file without faults.
    """
    constants = [
        text_of(file).split("\n")[int(line) - 1]
        for file, line in re.findall(r"^(?:\.\./)*([^\s:]+):(\d+):\d+: error: call to non-.constexpr. function", messages, re.M)
    ]
    found = {}
    for number, fault in faults.items():
        if not fault.file.endswith(".h"):
            continue
        above = "\n".join(text_of(fault.file).split("\n")[: fault.line])
        types = re.findall(r"^\s*(?:struct|class) (\w+)", above, re.M)
        if types and any(re.search(rf"\b{types[-1]}\b", constant) for constant in constants):
            found[number] = True
    return found
