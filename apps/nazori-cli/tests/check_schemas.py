#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs verbs of nazori-cli and compares what they answer with docs/schemas.

    check_schemas.py NAZORI_CLI SCHEMAS

A schema lets a reader pass over members that it does not know. Here it is closed: an answer that has a member
which the schema does not name, or lacks one, is refused. That the comparison would notice is tried too: each
member of each answer is renamed once, and must be refused then.
"""
import copy
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import zlib

from jsonschema import Draft202012Validator

PROGRAM, SCHEMAS = "", ""
BAR = [[[0.1, 0.5], [0.5, 0.5], [0.9, 0.5]]]


def closed(schema):
    """The schema without members that it does not name."""
    if isinstance(schema, list):
        return [closed(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    # What stands in "properties" and "$defs" are names, not words of the schema.
    result = {word: {name: closed(one) for name, one in value.items()} if word in ("properties", "$defs")
              else value if word in ("if", "then", "required", "enum", "const") else closed(value)
              for word, value in schema.items()}
    if "properties" in result and "additionalProperties" not in result:
        result["additionalProperties"] = False
    return result


def validator(name):
    """For "study#due": the definition "due" of docs/schemas/study.json."""
    file, definition = name.split("#")
    with open(os.path.join(SCHEMAS, file + ".json"), encoding="utf-8") as text:
        schema = json.load(text)
    Draft202012Validator.check_schema(schema)
    schema = closed(schema)
    if definition not in schema["$defs"]:
        raise KeyError(f"docs/schemas/{file}.json has no definition {definition}")
    return Draft202012Validator({"$defs": schema["$defs"], "$ref": "#/$defs/" + definition})


def shortened(value, kind, known):
    """The value with those elements of its lists that are the first, or have a member at a kind of place where earlier
    ones have none."""
    if isinstance(value, dict):
        known.update(kind + (name,) for name in value)
        return {name: shortened(one, kind + (name,), known) for name, one in value.items()}
    if not isinstance(value, list):
        return value
    kept = []
    for one in value:
        before = len(known)
        short = shortened(one, kind + (0,), known)
        if not kept or len(known) > before:
            kept.append(short)
    return kept


def renamed(document):
    """The document with one member under another name, once for each kind of place where there is one. It is the same
    object each time."""
    places = {}

    def walk(value, path, kind):
        if isinstance(value, dict):
            for name in value:
                places.setdefault(kind + (name,), (value, path + (name,)))
                walk(value[name], path + (name,), kind + (name,))
        elif isinstance(value, list):
            for i, one in enumerate(value):
                walk(one, path + (i,), kind + (0,))

    walk(document, (), ())
    for inside, path in places.values():
        inside[path[-1] + "_renamed"] = inside.pop(path[-1])
        yield "/".join(map(str, path)), document
        inside[path[-1]] = inside.pop(path[-1] + "_renamed")


class Schemas(unittest.TestCase):
    # Members whose names are data: a language, a kind of mistake, what a caller gave.
    FREE = ("meanings", "id")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def run_verb(self, *arguments, lines=None, code=0):
        text = None if lines is None else "".join(json.dumps(line) + "\n" if not isinstance(line, str)
                                                  else line + "\n" for line in lines)
        run = subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True, encoding="utf-8",
                             timeout=300, check=False)
        self.assertEqual(run.returncode, code, f"{arguments}: {run.stderr}")
        return run.stdout

    def check(self, name, document):
        """That a document is as the schema says, and that it would be noticed if it were not."""
        schema = validator(name)
        errors = [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:300]}" for e in schema.iter_errors(document)]
        self.assertEqual(errors, [], f"{name}: {json.dumps(document, ensure_ascii=False)[:400]}")
        # Comparing a history of thousands of lines once for each member would take minutes.
        short = shortened(document, (), set())
        for path, other in renamed(short if schema.is_valid(short) else copy.deepcopy(document)):
            if any(f"{free}/" in path + "/" and not path.endswith(free) for free in self.FREE):
                continue
            if path.split("/")[-2:-1] == ["kinds"] or path == "id":
                continue
            self.assertFalse(schema.is_valid(other), f"{name}: nobody notices that {path} is renamed")
        return document

    def answer(self, name, *arguments, code=0):
        return self.check(name, json.loads(self.run_verb(*arguments, "--json", code=code)))

    def answers(self, name, refusal, *arguments, lines, code=0):
        documents = [json.loads(line) for line in self.run_verb(*arguments, lines=lines, code=code).splitlines()]
        for document in documents:
            self.check(refusal if "error" in document else name, document)
        return documents

    def test_characters(self):
        self.answer("characters#info", "info", "休", "正", "あ")
        self.answer("characters#search", "search", "rest", "--limit", "5")
        self.assertEqual(self.answer("characters#info", "info", "U+10FFFF", code=1), [])

    def test_handwriting(self):
        bar = {"id": "a", "char": "一", "strokes": BAR}
        lines = [bar, {**bar, "times": [[0, 400, 600]], "pressures": [[0.5, 0.6, 0.2]], "box": [0, 0, 1]},
                 {**bar, "version": 1, "strokes": [[[0.9, 0.5], [0.1, 0.5]]]},
                 {"char": "土", "strokes": [[[0.2, 0.2], [0.8, 0.2]], [[0.5, 0.1], [0.5, 0.9]], [[0.3, 0.9], [0.7, 0.9]]]},
                 {"char": "十", "strokes": [[[0.1, 0.5], [0.9, 0.5]]]}]
        for line in lines:
            self.check("handwriting#grade_request", line)
        graded = self.answers("handwriting#grade", "handwriting#refused_grade", "grade", "--explain", "en",
                              lines=[*lines, {**bar, "version": 2}, {"id": 7}, "[", bar], code=2)
        self.assertEqual([("error" in one) for one in graded], [False] * 5 + [True] * 3 + [False])
        self.assertIn("motion", graded[1])
        self.assertTrue(any(one.get("errors") for one in graded))
        self.check("handwriting#handwriting", {"strokes": BAR})
        found = self.answers("handwriting#candidates", "handwriting#refused_candidates", "recognise",
                             lines=[{"id": 1, "strokes": BAR}, {"strokes": []}], code=2)
        self.assertEqual(found[0]["candidates"][0], "一")

    def test_speech(self):
        folder = self.path("sounds")
        os.mkdir(folder)
        head = struct.pack("<4sI4s4sIHHIIHH4sI", b"RIFF", 1636, b"WAVE", b"fmt ", 16, 1, 1, 8000, 16000, 2, 16, b"data", 1600)
        with open(os.path.join(folder, "か.wav"), "wb") as wav:
            wav.write(head + b"\0\x20" * 800)
        self.answer("speech#spoken", "speak", "か", "--recordings", folder, "--output", self.path("か.wav"))
        self.answer("speech#voices", "speak", "--voices", "--voice", "espeak-ng", code=0 if shutil.which("espeak-ng") else 1)

    def test_practice(self):
        cross = [[[14, 50], [95, 50]]], [[[54, 14], [54, 98]]]
        requests = [{"do": "watch"}, {"id": 3, "stage": "trace"}, {"strokes": cross[0] + cross[1]}, {"stage": "guided"},
                    {"strokes": cross[0] + cross[1]}, {"stage": "memory"}, {"do": "hint"}, {"strokes": cross[1]},
                    {"do": "undo"}, {"strokes": cross[0]}, {"strokes": cross[1]}, {"do": "clear"}, {"do": "answer"}]
        for request in requests:
            self.check("practice#request", request)
        lines = self.answers("practice#events", "practice#refused", "practise", "十",
                             lines=[*requests, {"do": "fly"}, {"version": 7, "do": "undo"}], code=2)
        events = [event for line in lines for event in line["events"]]
        self.assertEqual({event["event"] for event in events}, {"character", "feedback", "finished"})
        self.assertEqual(lines[0]["version"], 1)

        study = ("--learners", self.path("learners"), "--now", "2026-03-02T10:00Z")
        self.run_verb("study", "lists", "--import", self.write("few.txt", "一\n"), "--as", "few", *study)
        self.run_verb("study", "settings", 'new_lists=["list:few"]', *study)
        bar = {"strokes": [[[14, 54], [95, 54]]]}
        lines = self.answers("practice#events", "practice#refused", "practise", "--study", *study,
                             lines=[{"do": "watch"}, {"do": "go_on"}, bar, {"do": "go_on"}, bar, {"do": "go_on"}, bar,
                                    {"do": "good"}])
        events = [event for line in lines for event in line["events"]]
        self.assertLessEqual({"session", "announced"}, {event["event"] for event in events})
        self.assertTrue(any("proposed" in event for event in events))

    def test_study(self):
        first, later = "2026-01-01T09:00:00Z", "2026-01-09T09:00:00Z"

        def study(name, *arguments, now=first, code=0):
            return self.answer("study#" + name, "study", *arguments, "--learners", self.path("learners"), "--now", now,
                               code=code)

        study("due", "due")
        study("next", "next")
        study("review", "review", "休", "--rating", "easy", "--seconds", "20")
        for day in "2026-01-02", "2026-01-03":
            study("review", "review", "木", "--score", "72", "--fault", "wrong:3", "--seconds", "9", now=day + "T09:00:00Z")
        study("review", "review", "本", "--stage", "trace")
        study("review", "review", "休", "--stage", "brush", "--rating", "good")
        study("cards", "postpone", "休", "--days", "2")
        study("cards", "know", "日", "月")
        study("cards", "pause", "本")
        self.assertEqual(study("cards", "leech", code=1), [])
        study("undo", "undo")
        study("settings", "settings", "new_per_day=7")
        study("due", "due", now=later)
        statistics = study("stats", "stats", now=later)
        self.assertTrue(statistics["hard_strokes"] and statistics["days"] and statistics["forecast"])
        self.assertEqual(len(study("workload", "workload")), 18)
        study("list_import", "lists", "--import", self.write("list.txt", "木林森"), "--as", "trees")
        study("tag", "tag", "休", "--with", "rest")
        study("lists", "lists")
        self.assertEqual(study("list_members", "lists", "list:trees"), ["木", "林", "森"])
        export = self.path("me.json")
        study("export", "export", "--output", export)
        with open(export, encoding="utf-8") as text:
            learner = self.check("learner#learner", json.load(text))
        self.assertEqual({entry["kind"] for entry in learner["entries"]},
                         {"writing", "postpone", "pause", "undo", "settings", "known"})
        study("import", "import", export, "--profile", "Mari")
        self.assertEqual(study("profiles", "profiles"), ["Mari", "learner"])
        study("list_removal", "lists", "--remove", "trees")
        study("backup", "backup")
        self.assertTrue(study("backups", "restore", "--list"))
        study("rebuild", "rebuild")
        study("restore", "restore")

    def test_histories(self):
        steps = [{"at": "2026-01-01T09:00:00Z", "rating": 3}, {"at": "2026-01-04T09:00:00Z", "rating": 4}]
        history = self.check("histories#histories", {"cases": [{"request_retention": 0.9, "steps": steps}]})
        file = self.write("histories.json", json.dumps(history))
        replayed = self.run_verb("study", "replay", file)
        self.check("histories#replayed", json.loads(replayed))
        self.answer("study#replay_check", "study", "replay", self.write("again.json", replayed), "--check")
        newer = self.write("newer.json", json.dumps({**history, "version": 2}))
        self.run_verb("study", "replay", newer, code=2)

    def test_plots(self):
        self.answer("plots#plot", "plot", "y = tan(x); y = 1", "--window=-6,6,-4,4", "--size", "64")
        self.answer("plots#plot", "plot", "z = sin(x)cos(y)", "--size", "64")
        self.answer("plots#plot", "plot", "a = [1...3]; y = a x; ([1, 2, 3], [2, 4, 5]); y ~ b x + c", "--size", "64")
        self.answer("plots#plot", "plot", "([1, 2], 5); y ~ m", "--size", "64")
        # A file that the window saves; a test of libs/functions compares it with what is written.
        with open(os.path.join(SCHEMAS, "../../libs/functions/tests/fixtures/plot.json"), encoding="utf-8") as text:
            self.check("plots#plot_file", json.load(text))

    def test_tablets(self):
        self.answer("tablets#carve", "carve", "休木", "--output", self.folder.name, "--strokes", self.path("{}.str"),
                    "--size", "64")
        self.answer("tablets#model", "model", "鬱", "--raised", "--size-mm", "60", "--output", self.path("m.stl"))
        for name in ("m.nc", "m.svg", "m.pdf", "m.brf"):
            self.answer("tablets#touch_file", "model", "休", "--output", self.path(name))
        self.answer("tablets#worksheet", "worksheet", "休木", "--output", self.path("w.pdf"))
        self.answer("tablets#demo", "demo", "一", "--output", self.path("d.png"), "--size", "64", "--record",
                    self.path("d.nzr"))
        self.answer("tablets#record_info", "record", "info", self.path("d.nzr"))
        self.answer("tablets#record_export", "record", "export", self.path("d.nzr"), "--output", self.path("d.csv"))
        self.answer("tablets#paint", "paint", self.path("d.csv"), "--output", self.path("w.png"), "--cells", "128")
        self.answer("tablets#feel", "feel", "一", "--input", self.path("d.csv"), "--output", self.path("f.csv"))

    def test_characters_that_people_make(self):
        file = self.path("a.svg")
        self.answer("author#convert", "author", "convert", "二", "--output", file)
        (fine,) = self.answer("author#check", "author", "check", file)
        self.assertEqual(fine["findings"], [])
        with open(file, encoding="utf-8") as text:
            svg = text.read().replace("0 0 109 109", "0 0 9 9").replace("CC-BY-SA", "CC")
        (found,) = self.answer("author#check", "author", "check", self.write("b.svg", svg), code=1)
        self.assertEqual([one["kind"] for one in found["findings"]], ["licence_lost", "svg_view_box"])

        relief = self.path("a.raw")
        self.answer("author#convert", "author", "convert", "二", "--size", "256", "--output", relief)
        self.assertEqual(len(self.answer("author#trace", "author", "trace", relief)["strokes"]), 2)
        self.answer("author#trace", "author", "trace", relief, "--character", "二")

    def test_characters_that_are_kept(self):
        file = self.path("a.nazori")
        self.run_verb("author", "convert", "二", "--output", file)
        with unittest.mock.patch.dict(os.environ, NAZORI_CHARACTERS=self.path("characters")):
            (kept,) = self.answer("author#keep", "author", "keep", file)
            self.answer("author#kept", "author", "kept")
            self.answer("characters#info", "info", kept["code_point"])
            self.answer("characters#search", "search", "二")
            self.answer("author#remove", "author", "remove", kept["code_point"])

    def test_sheets_read_back(self):
        pdf, photo = self.path("s.pdf"), self.path("s.png")
        self.run_verb("worksheet", "一", "--copies", "0", "--output", pdf)
        page = subprocess.run(["pdftoppm", "-r", "100", "-gray", pdf], capture_output=True, check=True).stdout
        width, height = map(int, page.split(None, 3)[1:3])
        pixels = bytearray(page[-width * height:])
        (empty,) = self.answer("sheets#grade_sheet", "grade-sheet", self.picture(photo, width, height, pixels))
        # A short bar in the first cell, and a cross in the second.
        for cell, lines in ((0, ((0.3, 0.5, 0.7, 0.53),)), (1, ((0.1, 0.48, 0.9, 0.52), (0.48, 0.1, 0.52, 0.9)))):
            left, top = empty["sheets"][0]["cells"][cell]["corners"][0]
            right, low = empty["sheets"][0]["cells"][cell]["corners"][2]
            for x0, y0, x1, y1 in lines:
                for y in range(int(top + y0 * (low - top)), int(top + y1 * (low - top)) + 1):
                    for x in range(int(left + x0 * (right - left)), int(left + x1 * (right - left)) + 1):
                        pixels[y * width + x] = 20
        (read,) = self.answer("sheets#grade_sheet", "grade-sheet", self.picture(photo, width, height, pixels))
        cells = read["sheets"][0]["cells"]
        self.assertEqual([cell["state"] for cell in cells[:3]], ["legible", "illegible", "empty"])
        self.assertEqual([remark["flaw"] for remark in cells[0]["remarks"]], ["small"])
        self.assertEqual(cells[1]["looks_like"], "十")

    @staticmethod
    def picture(path, width, height, pixels):
        """Grey pixels as a PNG picture."""
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        rows = b"".join(b"\0" + bytes(pixels[y * width:(y + 1) * width]) for y in range(height))
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                       + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
        return path

    def test_pictures(self):
        self.answer("tablets#render", "render", "休", "--output", self.path("b.png"), "--size", "64x32")

    def test_devices(self):
        self.answer("devices#devices", "devices")
        self.answer("devices#trial", "devices", "--test", "0.2", "--device", "simulated:touch")

    def test_database(self):
        path = self.answer("database#path", "database", "path")["path"]
        self.answer("database#check", "database", "check", path)
        built = self.path("built.db")
        self.assertTrue(self.answer("database#build", "database", "build", "--output", built)["built"])
        self.assertFalse(self.answer("database#build", "database", "build", "--output", built)["built"])

    def test_schemas_say_what_they_are(self):
        for name in os.listdir(SCHEMAS):
            with open(os.path.join(SCHEMAS, name), encoding="utf-8") as text:
                schema = json.load(text)
            Draft202012Validator.check_schema(schema)
            self.assertEqual(schema["$schema"], "https://json-schema.org/draft/2020-12/schema", name)
            self.assertTrue(schema["title"], name)


if __name__ == "__main__":
    PROGRAM, SCHEMAS = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
