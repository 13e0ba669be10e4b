#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The writings that `nazori-cli grade` judges worst, as a table and a picture.

usage: worst_cases.py CLI OUTPUT.svg FILE.jsonl...
The files and the spoiled copies are those of calibrate_probability.py. The worst are those whose probability is farthest
from the truth: 0 for a right writing, 1 for one with a strange stroke. Prints a table in Markdown, and draws each
writing (black, a strange stroke red) over the model (grey) into OUTPUT.svg."""
import json
import random
import subprocess
import sys
from xml.sax.saxutils import escape

from calibrate_probability import spoiled, verdicts, writings_of

MOST = 50
COLUMNS = 10
CELL = 120  # of the picture; the model's own box has 109
BOX = 109
CAPTION = 34


def cases_of(file):
    """(character, strokes, number of the strange stroke from 0 or None, what was done, name of the writer)"""
    right = writings_of(file)
    name = file.rsplit("/", 1)[-1].split("-")[0].split(".")[0].rstrip("1")
    cases = [(w["char"], w["strokes"], None, "right", name) for w in right]
    chance = random.Random(file.rsplit("/", 1)[-1])
    for w in right:
        for keep_place, kind in ((True, "replaced"), (False, "reshaped")):
            strokes = spoiled(w, right, chance, keep_place)
            if strokes:
                strange = next(i for i, s in enumerate(strokes) if s is not w["strokes"][i])
                cases.append((w["char"], strokes, strange, kind, name))
    return cases


def path_of(stroke):
    """The stroke as a path in the box of the model, without points that lie within 1 unit of the last one."""
    points = [stroke[0]]
    for p in stroke[1:]:
        if max(abs(p[0] - points[-1][0]), abs(p[1] - points[-1][1])) * BOX >= 1:
            points.append(p)
    if len(points) == 1:
        points.append(stroke[-1])
    return "M" + "L".join(f"{p[0] * BOX:.0f},{p[1] * BOX:.0f}" for p in points)


def model_of(cli, character, known):
    if character not in known:
        answer = subprocess.run([cli, "info", character, "--json"], capture_output=True, text=True, check=True).stdout
        known[character] = [s["path"] for s in json.loads(answer)[0]["strokes"]]
    return known[character]


def picture_of(cli, worst):
    known = {}
    rows = (len(worst) + COLUMNS - 1) // COLUMNS
    svg = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {COLUMNS * CELL} {rows * (CELL + CAPTION)}" fill="none" '
        'stroke-linecap="round" stroke-linejoin="round" font-family="sans-serif" font-size="14">',
        '<rect width="100%" height="100%" fill="#fff"/>',
    ]
    for i, (_, probability, (character, strokes, strange, kind, name)) in enumerate(worst):
        x, y = i % COLUMNS * CELL, i // COLUMNS * (CELL + CAPTION)
        svg.append(f'<g transform="translate({x + 5},{y + 5})"><rect width="{BOX}" height="{BOX}" stroke="#ddd"/>')
        svg += [f'<path d="{d}" stroke="#bbb" stroke-width="5"/>' for d in model_of(cli, character, known)]
        for j, stroke in enumerate(strokes):
            colour = "#c00" if j == strange else "#000"
            svg.append(f'<path d="{path_of(stroke)}" stroke="{colour}" stroke-width="2"/>')
        svg.append(
            f'<text x="0" y="{BOX + 16}" fill="#000">{i + 1}. {escape(character)} {probability:.2f}</text>'
            f'<text x="0" y="{BOX + 32}" fill="#555">{kind}, {name}</text></g>'
        )
    return "\n".join(svg + ["</svg>\n"])


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    cli, output, files = sys.argv[1], sys.argv[2], sys.argv[3:]
    cases = [case for file in files for case in cases_of(file)]
    judged = []
    counts = {}
    for case, verdict in zip(cases, verdicts(cli, [case[:2] for case in cases]), strict=True):
        wrong_by = 1 - verdict["probability"] if case[3] == "right" else verdict["probability"]
        judged.append((wrong_by, verdict["probability"], case))
        of = counts.setdefault((case[4], case[3]), [0, 0])
        of[0] += 1
        of[1] += verdict["accepted"]
    judged.sort(key=lambda one: -one[0])
    worst = judged[:MOST]
    print("| writer | what | writings | accepted |\n|---|---|---:|---:|")
    for (name, kind), (all_of_them, accepted) in counts.items():
        print(f"| {name} | {kind} | {all_of_them} | {100 * accepted / all_of_them:.1f} % |")
    print("\n| | character | writer | what was done | said |\n|---|---|---|---|---:|")
    for i, (_, probability, (character, _, strange, kind, name)) in enumerate(worst):
        done = "nothing: it is right" if kind == "right" else f"stroke {strange + 1} {kind}"
        print(f"| {i + 1} | {character} | {name} | {done} | {probability:.2f} |")
    with open(output, "w", encoding="utf8") as picture:
        picture.write(picture_of(cli, worst))


if __name__ == "__main__":
    main()
