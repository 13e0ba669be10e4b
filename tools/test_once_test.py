#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/test-once remembers, tried on a small project of its own."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
BUILD = """rule cc
  command = cc -MD -MF $out.d $flags -c $in -o $out
  depfile = $out.d
  deps = gcc
rule ld
  command = cc $in -o $out
flags =
build a.o: cc {root}/a.c
build b.o: cc {root}/b.c
build bin/a: ld a.o
build bin/b: ld b.o
build a: phony bin/a
build b: phony bin/b
"""


class TestOnce(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.environment = {**os.environ, "XDG_CACHE_HOME": str(self.folder / "cache")}
        self.environment.pop("NAZORI_EVERY_TEST", None)
        self.root = self.make("first")

    def make(self, name):
        root = self.folder / name
        (root / "tools").mkdir(parents=True)
        shutil.copy(HERE / "test-once", root / "tools" / "test-once")
        (root / "data").mkdir()
        (root / "data" / "d.txt").write_text("1")
        (root / "code.h").write_text("#define CODE 0\n")
        for letter in "ab":
            header = '#include "code.h"\n' if letter == "a" else ""
            (root / f"{letter}.c").write_text(
                header + '#include <stdio.h>\nint main(void) { puts("ran"); return ' + ("CODE" if header else "0") + "; }\n")
        (root / "build").mkdir()
        (root / "build" / "build.ninja").write_text(BUILD.format(root=root))
        (root / ".gitignore").write_text("build\n")
        subprocess.run(["git", "init", "-q", str(root)], check=True)
        return root

    def run_test(self, root=None, *, target="a", arguments=(), code=0, **environment):
        root = root or self.root
        subprocess.run(["ninja", "-C", str(root / "build"), target], check=True, capture_output=True)
        run = subprocess.run(
            [root / "tools" / "test-once", str(root / "build"), target, "--tree", "data", "--",
             root / "build" / "bin" / target, *arguments],
            env={**self.environment, **environment}, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, code, run.stderr)
        return "ran" in run.stdout

    def test_a_program_that_passed_is_not_run_again(self):
        self.assertTrue(self.run_test())
        self.assertFalse(self.run_test())
        self.assertTrue(self.run_test(NAZORI_EVERY_TEST="1"))

    def test_another_checkout_of_the_same_files_is_the_same(self):
        self.assertTrue(self.run_test())
        self.assertFalse(self.run_test(self.make("second")))

    def test_a_program_that_failed_is_run_again(self):
        (self.root / "code.h").write_text("#define CODE 3\n")
        self.assertTrue(self.run_test(code=3))
        self.assertTrue(self.run_test(code=3))

    def test_whatever_it_depends_on_runs_it_again(self):
        self.run_test()
        for change in (lambda: (self.root / "code.h").write_text("#define CODE 0 // other\n"),
                       lambda: (self.root / "data" / "d.txt").write_text("2"),
                       lambda: (self.root / "data" / "new.txt").write_text("")):
            change()
            self.assertTrue(self.run_test())
            self.assertFalse(self.run_test())
        self.assertTrue(self.run_test(arguments=["--other"]))
        self.assertTrue(self.run_test(GTEST_SHARD_INDEX="1"))
        ninja = self.root / "build" / "build.ninja"
        ninja.write_text(ninja.read_text().replace("flags =", "flags = -O1"))
        self.assertTrue(self.run_test())

    def test_kanji_db_counts_where_the_test_may_read_it(self):
        database = self.folder / "kanji.db"
        database.write_text("1")
        self.assertTrue(self.run_test(NAZORI_DATA=str(self.folder)))
        self.assertFalse(self.run_test(NAZORI_DATA=str(self.folder)))
        database.write_text("2")
        self.assertTrue(self.run_test(NAZORI_DATA=str(self.folder)))

    def test_what_it_does_not_depend_on_counts_for_nothing(self):
        self.run_test(target="b")
        (self.root / "code.h").write_text("#define CODE 3\n")
        self.assertFalse(self.run_test(target="b"))


if __name__ == "__main__":
    unittest.main()
