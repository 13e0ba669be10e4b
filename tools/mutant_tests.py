# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of a module with one of its faults awake, for tools/mutants."""
import dataclasses
import functools
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / "build" / "mutants"
TREE = WORK / "tree"
# As far below the sources as the build of `make test`: the compiler cache finds what that one compiled.
BUILD = TREE / "build" / "release"
DATA = ROOT / "build" / "data"
PATIENCE = 8  # times what the tests take without a fault
LEAST_PATIENCE_S = 20


@functools.cache
def isolated_suites(name):
    """The suites of a module whose tests need a process each, as a pattern: they have one set of signals."""
    if name == "cli":
        return ".*"
    folder = ROOT / "libs" / name
    wanted = re.search(r'ISOLATED_TESTS "(.*?)"', (folder / "CMakeLists.txt").read_text())
    files = [f for f in folder.glob("tests/*_test.cpp") if wanted and re.search(wanted.group(1), f"tests/{f.name}")]
    suites = sorted({suite for f in files for suite in re.findall(r"^TEST(?:_F|_P)?\((\w+),", f.read_text(), re.M)})
    return rf"(?:.*/)?(?:{'|'.join(suites)})(?:/.*)?" if suites else ""


running = set()


def run(command, seconds, **options):
    """@return the exit code and what was printed; code None where it took too long."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               errors="replace", start_new_session=True, **options)
    running.add(process)
    try:
        out, _ = process.communicate(timeout=seconds)
        return process.returncode, out
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return None, process.communicate()[0]
    finally:
        running.discard(process)


def stop_all():
    for process in list(running):
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


measured = {}  # seconds that a suite takes, by program and filter


@dataclasses.dataclass
class Suite:
    """Some tests that run in one process."""
    program: str
    filter: str
    alone: bool  # they may not share it with others
    seconds: float = 0
    reaches: bytes = b""
    fails: bool = False  # also without a fault


def suites_of(name):
    """The suites of a module, each with the time that it took when it was measured, else half a minute."""
    code, out = run([str(BUILD / "bin" / f"nazori_{name}_tests"), "--gtest_list_tests"], 120)
    if code != 0:
        sys.exit(f"{out[-3000:]}\nnazori: mutants: the tests of {name} do not begin")
    suites = []
    for line in out.splitlines():
        word = line.split("#")[0].rstrip()
        if re.match(r"\S+\.$", word):
            suite = word
            alone = bool(re.fullmatch(isolated_suites(name), suite[:-1]))
            if not alone:
                suites.append(Suite(name, suite + "*", False))
        elif word.startswith("  ") and alone:
            suites.append(Suite(name, suite + word.strip(), True))
    for suite in suites:
        suite.seconds = measured.get((name, suite.filter), 30)
    return suites


def run_tests(name, filters, fault, seconds, reached=None):
    """@return the first test that failed, "" where all passed, None where they came to no end."""
    folder = BUILD / ("apps/nazori-cli" if name == "cli" else f"libs/{name}")
    with tempfile.TemporaryDirectory(prefix="mutants") as place:
        # Tests that give up the rights of root go on in it.
        os.chmod(place, 0o755)
        environment = dict(os.environ, NAZORI_DATA=str(DATA), QT_QPA_PLATFORM="offscreen", LP_NUM_THREADS="0", TMPDIR=place,
                           NAZORI_TEST_PATIENCE_S="8", NAZORI_FAULT=str(fault))
        if reached:
            environment["NAZORI_FAULT_REACHED"] = reached
        # A fault may fill the memory or the disk.
        code, out = run(["prlimit", "--core=0", f"--data={6 << 30}:", f"--fsize={2 << 30}:", str(BUILD / "bin" / f"nazori_{name}_tests"),
                         "--gtest_fail_fast", f"--gtest_filter={':'.join(filters)}"], seconds, env=environment, cwd=folder)
    if code == 0:
        return ""
    if failed := re.search(r"^\[  FAILED  \] (\S+?),?(?: \(|$)", out, re.M):
        return failed.group(1)
    began = re.findall(r"^\[ RUN      \] (\S+)$", out, re.M)
    return None if code is None else began[-1] if began else f"code {code}"


def patience(suites):
    return max(LEAST_PATIENCE_S, PATIENCE * sum(suite.seconds for suite in suites))


def survey(name, pool):
    """Runs all suites of a module without a fault. @return them, with the faults that they reach."""
    suites = suites_of(name)

    def look(suite):
        with tempfile.NamedTemporaryFile(prefix="mutants") as file:
            file.truncate(65536)
            for _ in range(3):
                began = time.monotonic()
                failed = run_tests(name, [suite.filter], 0, 600, file.name)
                suite.seconds = measured[name, suite.filter] = time.monotonic() - began
                if failed == "":
                    break
            suite.fails = failed != ""
            suite.reaches = pathlib.Path(file.name).read_bytes()
        if suite.fails:
            print(f"nazori: mutants: {name}: {failed or suite.filter} fails without a fault; it is left out", flush=True)

    list(pool.map(look, suites))
    return [suite for suite in suites if not suite.fails]


def notices(number, suites, built_alone=False):
    """@return what notices a fault: a test, or "" for none. Who fails only now and then, or without it, has noticed nothing."""
    together = [suite for suite in suites if not suite.alone]
    for group in ([together] if together else []) + [[suite] for suite in suites if suite.alone]:
        name, filters, seconds = group[0].program, [suite.filter for suite in group], patience(group)
        for trial in range(2):
            failed = run_tests(name, filters, number, seconds)
            if failed == "":
                break
            # The test alone, then with those before it.
            again = [failed] if failed and " " not in failed and trial == 0 else filters
            if run_tests(name, again, number, seconds) == "":
                continue
            if built_alone or run_tests(name, again, 0, seconds) == "":
                return f"{name}: {failed or 'no end'}"
    return ""
