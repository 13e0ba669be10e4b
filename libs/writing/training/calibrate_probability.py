#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How well the probability of `nazori-cli grade` is calibrated.

usage: calibrate_probability.py CLI FILE.jsonl...
Each line of a file is a right writing: {"char": "休", "strokes": [[[x, y], ...], ...]} in a box of side 1. A line
whose "status" is not "ok" is left out. Every writing counts once as right, and once as wrong: as copies in which one
stroke is replaced by a strange one (as it lies in its own box, or moved and scaled to the place of the stroke). Prints
the Brier score, the reliability table, and the correction of the log odds (a + b * log odds) that logistic regression
finds; 0 and 1 mean that nothing is left to correct."""
import json
import math
import random
import subprocess
import sys

COPIES = 3  # of each kind
SAMPLES = 24


def length(line):
    return sum(math.dist(a, b) for a, b in zip(line, line[1:]))


def sampled(line):
    """Points at equal steps."""
    step = length(line) / (SAMPLES - 1)
    points, left, at = [line[0]], step, line[0]
    for to in line[1:]:
        rest = math.dist(at, to)
        while rest >= left > 0 and len(points) < SAMPLES:
            at = [at[i] + (to[i] - at[i]) * left / rest for i in (0, 1)]
            points.append(at)
            rest -= left
            left = step
        left -= rest
        at = to
    return points + [line[-1]] * (SAMPLES - len(points))


def centre(line):
    points = sampled(line)
    return [sum(p[i] for p in points) / SAMPLES for i in (0, 1)]


def moved(line, to, scale):
    c = centre(line)
    return [[to[i] + (p[i] - c[i]) * scale for i in (0, 1)] for p in line]


def apart(a, b):
    return sum(math.dist(p, q) for p, q in zip(sampled(a), sampled(b))) / SAMPLES


def spoiled(writing, others, chance, keep_place):
    """The writing with one strange stroke; None where none was found."""
    strokes = writing["strokes"]
    k = chance.randrange(len(strokes))
    own = strokes[k]
    for _ in range(500):
        other = chance.choice(others)
        strange = chance.choice(other["strokes"])
        if other["char"] == writing["char"] or min(length(own), length(strange)) < 0.02:
            continue
        if not keep_place:
            unit = [moved(s, [0, 0], 1 / length(s)) for s in (own, strange)]
            if apart(*unit) <= 0.20:
                continue
            strange = moved(strange, centre(own), length(own) / length(strange))
        elif apart(own, strange) <= 0.15:
            continue
        return strokes[:k] + [strange] + strokes[k + 1 :]
    return None


def writings_of(file):
    with open(file, encoding="utf8") as lines:
        all_of_it = [json.loads(line) for line in lines if line.strip()]
    for w in all_of_it:
        w["strokes"] = [[p[:2] for p in s] for s in w["strokes"]]
    count = "kvg_strokes"
    return [w for w in all_of_it if w.get("status", "ok") == "ok" and w.get(count, len(w["strokes"])) == len(w["strokes"])]


def verdicts(cli, drawings):
    """What the program says of each (character, strokes), in order."""
    lines = "".join(json.dumps({"char": c, "strokes": s}) + "\n" for c, s in drawings)
    answer = subprocess.run([cli, "grade"], input=lines, capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in answer.splitlines()]


def graded(cli, file):
    """(log odds, is right, weight) of each drawing."""
    right = writings_of(file)
    jobs = [(w["char"], w["strokes"], True, 1) for w in right]
    chance = random.Random(file.rsplit("/", 1)[-1])
    for w in right:
        for keep_place in (True, False):
            for _ in range(COPIES):
                strokes = spoiled(w, right, chance, keep_place)
                if strokes:
                    jobs.append((w["char"], strokes, False, 1 / (2 * COPIES)))
    result = []
    for (_, _, is_right, weight), verdict in zip(jobs, verdicts(cli, [job[:2] for job in jobs]), strict=True):
        p = min(max(verdict["probability"], 1e-4), 1 - 1e-4)
        result.append((math.log(p / (1 - p)), is_right, weight))
    return result


def probability(log_odds):
    return 1 / (1 + math.exp(-max(min(log_odds, 700), -700)))


def regression(rows):
    """a and b of a + b * log odds, by Newton's method."""
    a, b = 0.0, 1.0
    for _ in range(50):
        ga = gb = aa = ab = bb = 0.0
        for x, y, w in rows:
            p = probability(a + b * x)
            ga += w * (y - p)
            gb += w * (y - p) * x
            aa += w * p * (1 - p)
            ab += w * p * (1 - p) * x
            bb += w * p * (1 - p) * x * x
        size = aa * bb - ab * ab
        if size < 1e-12:  # right and wrong ones do not overlap: no correction is the best
            return math.nan, math.nan
        a, b = a + (bb * ga - ab * gb) / size, b + (aa * gb - ab * ga) / size
    return a, b


def report(name, rows):
    weight = sum(w for _, _, w in rows)
    brier = sum(w * (probability(x) - y) ** 2 for x, y, w in rows) / weight
    a, b = regression(rows)
    print(f"{name}: {len(rows)} drawings, Brier score {brier:.4f}, correction {a:+.2f} {b:.2f}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    together = []
    for file in sys.argv[2:]:
        rows = graded(sys.argv[1], file)
        report(file.rsplit("/", 1)[-1], rows)
        together += rows
    report("together", together)
    for tenth in range(10):
        inside = [r for r in together if min(9, int(10 * probability(r[0]))) == tenth]
        weight = sum(w for _, _, w in inside)
        if weight:
            said = sum(w * probability(x) for x, _, w in inside) / weight
            was = sum(w for _, y, w in inside if y) / weight
            print(f"{tenth / 10:.1f} to {tenth / 10 + 0.1:.1f}: weight {weight:6.1f}, said {said:.3f}, right {was:.3f}")


if __name__ == "__main__":
    main()
