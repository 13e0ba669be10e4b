#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/mutants plants in small examples, and what it leaves alone. tools/check runs it."""
import concurrent.futures
import contextlib
import importlib.machinery
import importlib.util
import io
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from mutant_guards import HEADER, behind_constants, blamed, guarded, planted as planted_text  # noqa: E402
from mutant_sites import faults_of  # noqa: E402
from mutant_tests import Suite  # noqa: E402


def planted(line, before="  first();"):
    """(kind, the line afterwards) of each fault in a line of a function."""
    text = f"void f() {{\n{before}\n  {line}\n}}\n"
    return [(fault.kind, fault.after.strip()) for fault in faults_of("f.cpp", text) if fault.line == 3]


class Planted(unittest.TestCase):
    def has(self, line, kind, after):
        self.assertIn((kind, after), planted(line))

    def test_a_comparison_gets_its_other_bound_and_its_opposite(self):
        for sign, others in {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"),
                             "==": ("!=",), "!=": ("==",)}.items():
            found = [after for kind, after in planted(f"return a {sign} n;") if kind == "comparison"]
            self.assertEqual(found, [f"return a {other} n;" for other in others])

    def test_a_quantity_gets_only_the_opposite(self):
        found = [after for kind, after in planted("return width < 0.5 * depth;") if kind == "comparison"]
        self.assertEqual(found, ["return width >= 0.5 * depth;"])

    def test_a_sign_turns_round(self):
        self.has("return a + b;", "sign", "return a - b;")
        self.has("return a - b;", "sign", "return a + b;")
        self.has("return -a;", "sign", "return a;")
        self.has("g(-a);", "sign", "g(a);")

    def test_a_whole_number_is_one_more(self):
        self.has("return n + 1;", "off by one", "return n + 2;")
        self.has("return list[0];", "off by one", "return list[1];")

    def test_the_number_of_an_element_is_one_less(self):
        self.assertEqual(planted("return list[3];"), [("off by one", "return list[2];")])

    def test_a_constant_is_two_fifths_larger(self):
        self.has("x = 0.05;", "constant", "x = 0.07;")
        self.has("x = 2.0F;", "constant", "x = 2.8F;")
        self.has("x = 1e-3;", "constant", "x = 0.0014;")
        self.has("x = 60'000;", "constant", "x = 84000;")
        self.has("constexpr double kMost_n = 250;", "constant", "constexpr double kMost_n = 350;")
        self.has("x = 0.0;", "constant", "x = 1.0;")
        for number in ("1e-9", "2.5e-9", "1e+9"):
            self.assertEqual([kind for kind, _ in planted(f"return {number};")], ["constant"], number)

    def test_a_check_is_dropped(self):
        self.has("return a && b || c;", "dropped check", "return a || c;")
        self.has("return a && (b || c);", "dropped check", "return a;")
        self.has("if (a) g();", "dropped check", "if (false) g();")

    def test_a_statement_is_dropped_or_comes_after_the_end(self):
        self.has("list.clear();", "dropped statement", "")
        self.has("list.clear();", "early return", "return; list.clear();")
        self.has("count_ = 0;", "dropped statement", "")
        kinds = [kind for kind, _ in planted("return g();")]
        self.assertNotIn("dropped statement", kinds)

    def test_the_second_line_of_a_statement_is_no_statement(self):
        self.assertNotIn("dropped statement", [kind for kind, _ in planted("list.clear();", before="  g(a,")])

    def test_arguments_change_places(self):
        self.has("g(a, b);", "swapped arguments", "g(b, a);")
        for call in ("min", "minmax", "fma", "swap"):
            self.assertNotIn("swapped arguments", [kind for kind, _ in planted(f"x = std::{call}(a, b);")])
        for line in ("points.reserve(a);", "line_->points.reserve(count + 1);", "all[0].reserve(2 * f(a, b));"):
            self.assertEqual(planted(line), [], line)
        self.assertNotIn("off by one", [kind for kind, _ in planted("std::array<int, 6> names;")])

    def test_what_is_not_code_is_left_alone(self):
        for line in ("// a < b, 1 + 2", "#include <a>", 'static_assert(sizeof(int) == 4);', "assert(a < b);", "using a = b;"):
            self.assertEqual(planted(line), [], line)
        self.assertEqual([a for k, a in planted('say("1 < 2");') if k in ("comparison", "off by one")], [])
        self.assertEqual([a for k, a in planted("std::vector<int> a;") if k == "comparison"], [])

    def test_what_a_private_member_begins_with_is_left_alone(self):
        for line in ("double weight_ = 0;", "std::array<Tone, 4> axes_{{}};", "Vec3 force_{0, 0, 0};"):
            self.assertEqual(faults_of("f.h", f"class F {{\n  {line}\n}};\n"), [], line)
        self.assertTrue(faults_of("f.h", "struct F {\n  double weight = 0;\n};\n"))

    def test_every_fault_changes_its_line_alone(self):
        text = "int f(int a, int b) {\n  if (a < b && a > 1) return g(a, b) - 2;\n  list[a].push_back(b + 1);\n  return 0;\n}\n"
        faults = faults_of("f.cpp", text)
        self.assertGreater(len(faults), 10)
        for fault in faults:
            self.assertEqual(fault.before, text.split("\n")[fault.line - 1])
            self.assertNotEqual(fault.after, fault.before)
            self.assertNotIn("\n", fault.after)


# A program that prints what each of its functions returns. Its faults change the results.
PROGRAM = """#include <array>
#include <cstdio>
#include <vector>
constexpr double kScale = 0.5;
constexpr std::array<int, 2> kPair{3, 4};
int before(int a, int b) {
  return a < b && b > 1 ? a + b * 2 - 1 : a - b;
}
int same(int a, int b) {
  if (a == b || a > 5) return 1;
  return before(a, b);
}
double scaled(double a) {
  const double turned = kScale * -a / 2;
  return turned;
}
void grow(std::vector<int>& list) {
  list.push_back(7);
  list.push_back(8);
}
int main() {
  std::vector<int> list;
  grow(list);
  std::printf("%d %d %d %d %g %zu %d", before(1, 2), before(2, 2), same(2, 2), same(6, 3), scaled(3), list.size(), kPair[0]);
  return 0;
}
"""


def results(folder, text, faults):
    """What the program prints with each fault; what the compiler says where it does not compile. 0: with none."""
    with tempfile.TemporaryDirectory(dir=folder) as place:
        program = pathlib.Path(place) / "p"
        built = subprocess.run(["c++", "-std=c++20", "-w", "-x", "c++", "-I", ".", "-o", program, "-"], cwd=folder, input='# 1 "p.cpp"\n' + text,
                               capture_output=True, text=True)
        if built.returncode != 0:
            return built.stderr
        return {number: subprocess.run([program], env={"NAZORI_FAULT": str(number)}, capture_output=True).stdout for number in faults}


class Asleep(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)
        (self.folder / "planted.h").write_text(HEADER)

    def test_a_fault_that_is_awake_does_what_it_does_when_it_is_planted_alone(self):
        faults = dict(enumerate((f for f in faults_of("p.cpp", PROGRAM) if f.line < 21), 1))
        kinds = {fault.kind for fault in faults.values()}
        self.assertEqual(kinds, {"comparison", "sign", "off by one", "constant", "dropped check", "dropped statement", "early return",
                                 "swapped arguments"})
        right = results(self.folder, PROGRAM, [0])[0]
        compared = 0
        # One fault a line: as many builds as the line with the most faults has.
        for turn in range(max(sum(f.line == g.line for f in faults.values()) for g in faults.values())):
            some = {}
            for line in {fault.line for fault in faults.values()}:
                here = [number for number, fault in faults.items() if fault.line == line]
                if turn < len(here) and guarded(faults[here[turn]], here[turn]):
                    some[here[turn]] = faults[here[turn]]
            found = ""
            while isinstance(found, str):
                for number in blamed(found, some):
                    del some[number]
                found = results(self.folder, planted_text(PROGRAM, some, self.folder / "planted.h"), [0, *some])
            self.assertEqual(found.pop(0), right)

            def alone(number):
                lines = PROGRAM.split("\n")
                lines[faults[number].line - 1] = faults[number].after
                return results(self.folder, "\n".join(lines), [0])

            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
                for (number, printed), expected in zip(found.items(), threads.map(alone, found)):
                    self.assertEqual({0: printed}, expected, str(faults[number]))
                    compared += 1
        self.assertGreater(compared, 25)

    def guarded(self, line, kind, instead=None):
        faults = [fault for fault in faults_of("f.cpp", f"void f() {{\n  first();\n  {line}\n}}\n")
                  if fault.line == 3 and fault.kind == kind and instead in (None, fault.instead)]
        return guarded(faults[0], 7).strip()

    def test_each_kind_is_written_so(self):
        is7 = "nazori_planted::is(7)"
        self.assertEqual(self.guarded("list.clear();", "dropped statement"), f"if (!{is7}) list.clear();")
        self.assertEqual(self.guarded("list.clear();", "early return"), f"if ({is7}) return; list.clear();")
        self.assertEqual(self.guarded("if (a) g();", "dropped check"), f"if (!{is7} && (a)) g();")
        self.assertEqual(self.guarded("return a && b;", "dropped check"), f"return a && ({is7} || (b));")
        self.assertEqual(self.guarded("return a || b;", "dropped check"), f"return a || (!{is7} && (b));")
        self.assertEqual(self.guarded("g(a, b);", "swapped arguments"), f"g(({is7} ? b : a), ({is7} ? a : b));")
        self.assertEqual(self.guarded("x = -a.b(c) * d;", "sign"), f"x = ({is7} ? (a.b(c)) : -(a.b(c))) * d;")
        self.assertEqual(self.guarded("x = 0.5F;", "constant"), f"x = ({is7} ? 0.7F : 0.5F);")

    def test_a_constant_is_none_for_the_compiler(self):
        def first(file, line):
            return guarded(faults_of(file, line)[0], 7).split("(nazori")[0]
        self.assertEqual(first("f.cpp", "constexpr double kA = 0.5;"), "const double kA = ")
        self.assertEqual(first("f.h", "inline constexpr double kA = 0.5;"), "inline const double kA = ")
        self.assertEqual(first("f.h", "  static constexpr double kA = 0.5;"), "  static inline const double kA = ")
        self.assertEqual(first("f.cpp", "  constexpr double kA = 0.5;"), "  static const double kA = ")
        self.assertEqual(first("f.h", "constexpr double half(double a) { return a * 0.5; }"), "inline double half(double a) { return a * ")

    def test_the_compiler_blames_a_fault_by_its_line(self):
        fault = faults_of("libs/a/src/f.cpp", "int n = 3;")[0]
        error = "../../libs/a/src/f.cpp:1:9: error: the value is not usable in a constant expression\n"
        self.assertEqual(blamed(error, {4: fault}), {4: True})
        self.assertEqual(blamed(error.replace("the value is not usable in a constant expression", "no match"), {4: fault}), {4: False})
        self.assertEqual(blamed("libs/b.cpp:7:1: error: no\nlibs/a/src/f.cpp:1:5: note: declared here\n", {4: fault}), {4: False})
        self.assertEqual(blamed("libs/a/src/g.cpp:1:5: error: no\n", {4: fault}), {})

    def test_an_early_return_within_an_argument_is_blamed_where_the_call_is_mentioned(self):
        calls = "libs/a/src/inside.h:61:18: error: could not convert\nlibs/a/src/f.cpp:3:20:   required from here\n"
        lines = "\n" * 3 + "  n = 3;\n" + "\n" * 30 + "  n = 4;\n"
        faults = {f.line: f for f in faults_of("libs/a/src/f.cpp", f"void f() {{{lines}}}\n") if f.kind == "off by one"}
        self.assertEqual(sorted(faults), [4, 35])
        self.assertEqual(blamed(calls, faults), {4: False})

    def test_an_early_return_within_a_lambda_is_blamed_where_its_other_return_is(self):
        told = "../../libs/a/src/f.cpp:3:12: error: inconsistent types ‘void’ and ‘int’ deduced for lambda return type\n"
        faults = {n: faults_of(f"libs/a/src/{name}.cpp", "void f() {\n  n = 3;\n}\n")[0] for n, name in ((4, "f"), (5, "g"))}
        self.assertEqual(faults[4].line, 2)
        self.assertEqual(blamed(told, faults), {4: False})

    def test_the_default_of_a_member_is_blamed_where_a_constant_of_its_type_is_none_any_more(self):
        header = "struct Place {\n  int at = 0;\n};\nstruct Limits {\n  int depth = 64;\n};\n"
        sources = {"libs/a/include/limits.h": header, "libs/b/src/b.cpp": "int first();\nconstexpr Limits kLimits{};\n"}
        depth = next(f for f in faults_of("libs/a/include/limits.h", header) if f.line == 5)
        place = next(f for f in faults_of("libs/a/include/limits.h", header) if f.line == 2)
        faults = {3: depth, 4: place}
        told = "../../libs/b/src/b.cpp:2:26: error: call to non-‘constexpr’ function ‘bool nazori_planted::is(int)’\n"
        self.assertEqual(behind_constants(told, faults, sources.get), {3: True})
        self.assertEqual(behind_constants(told.replace(":2:26", ":1:5"), faults, sources.get), {})
        self.assertEqual(behind_constants(told.replace("call to", "no"), faults, sources.get), {})


class Rounds(unittest.TestCase):
    def test_a_fault_that_the_module_does_not_notice_is_shown_to_its_users_and_one_that_does_not_compile_is_replaced(self):
        place = str(pathlib.Path(__file__).resolve().parent / "mutants")
        loader = importlib.machinery.SourceFileLoader("mutants", place)
        mutants = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutants", loader))
        loader.exec_module(mutants)
        faults = [f for f in faults_of("f.cpp", "\n".join("  list.clear();" for _ in range(40))) if f.kind == "dropped statement"]
        built = []

        def grow(plot, faults, names):
            built.append((len(faults), names))
            return {number: fault for number, fault in faults.items() if fault.line % 7}, {}

        def notices(number, suites):
            by = suites[0].program
            return f"{by}: T" if (by == "own" and number % 2) or (by == "far" and number % 4 == 0) else ""

        mutants.Plot.grow = grow
        mutants.survey = lambda name, pool: [Suite(name, "S.*", False, 1, bytes([1] * 65536))]
        mutants.notices = notices
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            season = mutants.Season(["own"], {"own": ["near", "far"]}, ["near", "far"], {"own": faults}, 20, 2,
                                    pathlib.Path(folder) / "log.jsonl")
            self.assertTrue(season.round())
            self.assertFalse(season.round())
        by = [result["by"] for result in season.results("own")]
        self.assertEqual({one: by.count(one) for one in set(by)}, {"own: T": 10, "far: T": 5, "": 5})
        self.assertEqual(built, [(32, ["own"]), (10, ["near", "far"])])


if __name__ == "__main__":
    unittest.main()
