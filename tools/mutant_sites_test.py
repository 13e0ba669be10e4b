#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/mutants plants in small examples, and what it leaves alone. tools/check runs it."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from mutant_sites import faults_of  # noqa: E402


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


if __name__ == "__main__":
    unittest.main()
