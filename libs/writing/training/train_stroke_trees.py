#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Trains the trees that tell how strange a stroke is, and writes them.

usage: train_stroke_trees.py FEATURES KANJI.DB OUT.trees FILE.jsonl...
FEATURES is the program nazori_stroke_features. The files are those of calibrate_probability.py, and so are the strange
strokes. Needs numpy and scikit-learn. A stroke of a right writing is right, and so are the others beside a strange one. Beginnings
of writings are learned, too, because strokes are also judged as they are written; and writings of the same hands made
steadier and rougher; and models of the database, from neater than any hand to as slanted and shaken as may be, also with
strokes cut to a third or moved (strange) or made longer (right, because that is only advice). Prints how many right writings are
accepted and how many strange strokes are told when a file is left out, and when every
fifth character of each file is left out in turn (the same hand, characters that were never seen), and writes the trees learned
from all of them.
Their answer is calibrated: the log odds that a writing whose strangest stroke it is has a strange stroke, where there
are a few more right ones than strange ones."""
import math
import random
import struct
import subprocess
import sys

import numpy
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.linear_model import LogisticRegression

from calibrate_probability import centre, length, moved, sampled, spoiled, writings_of

FEATURES = 103  # of a stroke: kStrokeFeatures of strangeness.h
COPIES = 200_000  # strokes of each file, about, so that a small file is spoiled more often than a large one
MOST_COPIES = 12  # of each kind
# What can only make a stroke stranger: the deviation and its share of the allowance, and single parts of both.
GROWING = (0, 1, 7, 12, 13, 15, 16, 19, 25, 27, 28, 32, 33, 34, 35)
OF_BEGINNING, OF_BESIDE = 0.3, 0.5  # weights beside the strokes of a right writing
MOST_BESIDE = 2  # strokes beside a strange one
LARGE = 10_000  # samples
MANY = 1_000  # writings
PARTS = 5  # of the characters of a hand
ENLARGED, ENLARGED_OF_MANY = (0.3, 1.3), (0.5, 1.4)  # of what strokes differ from the model by; hands, and drawn templates
COPIES_OF_ENLARGED = 4
CUTS = 3  # of each model
RIGHT_TO_STRANGE = 1.25  # a right writing that is refused is as bad as so many strange ones that are accepted
WEIGHT_OF_LARGE = 2  # a set of so many, beside each small one
TREES = dict(max_iter=200, learning_rate=0.1, max_leaf_nodes=15, min_samples_leaf=40, l2_regularization=1, random_state=1)


class Sample:
    """A writing, or a beginning of one: its strokes' features, and which of them is strange."""

    def __init__(self, character, strokes, strange, is_beginning, kind):
        self.character, self.strokes, self.strange = character, strokes, strange
        self.is_beginning, self.kind = is_beginning, kind
        self.features = None  # none where its strokes were not found one for one
        self.drawn = self.reversed = None


def models_in(program, database):
    """The strokes of each character of the database."""
    answer = subprocess.run([program, database, "--models"], capture_output=True, text=True, check=True)
    models = {}
    for line in answer.stdout.splitlines():
        numbers = iter(line.split())
        character, _, count = chr(int(next(numbers))), next(numbers), int(next(numbers))
        models[character] = [
            [[float(next(numbers)), float(next(numbers))] for _ in range(int(next(numbers)))] for _ in range(count)
        ]
    return models


def drawn_models(models):
    """Every third model, drawn by hands of all steadiness: as it is, or each stroke turned, moved, and stretched a little,
    and the whole slanted."""
    chance = random.Random("models")
    writings = []
    for character in list(models)[::3]:
        rough = max(0.0, chance.uniform(-0.4, 1.0))
        slant = slanted(rough, chance)
        strokes = [[slant(p) for p in drawn_by_hand(points, rough, chance)] for points in models[character]]
        writings.append({"char": character, "strokes": strokes})
    return writings


def slanted(rough, chance):
    """A map of points: the whole turned, slanted and stretched."""
    turn, slant, aspect = (chance.uniform(-most, most) * min(1, 2 * rough) for most in (0.14, 0.15, 0.18))
    c, s, wide = math.cos(turn), math.sin(turn), math.exp(aspect)
    return lambda p: [wide * c * p[0] + (slant - s) * p[1], wide * s * p[0] + c * p[1]]


def drawn_by_hand(points, rough, chance):
    if rough == 0:
        return points
    c = centre(points)
    turn, size = chance.gauss(0, 0.06 * rough), math.exp(chance.gauss(0, 0.08 * rough))
    away = [chance.gauss(0, 0.014 * rough) for _ in (0, 1)]
    shake = 0.01 * rough * chance.random()
    result = []
    for p in sampled(points)[::2] + points[-1:]:
        x, y = ((p[i] - c[i]) * size for i in (0, 1))
        x, y = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
        result.append([c[0] + x + away[0] + chance.gauss(0, shake), c[1] + y + away[1] + chance.gauss(0, shake)])
    return result


def laid_over(model, strokes):
    """The model's strokes where the writing has them: moved, and each axis stretched."""
    a, b = numpy.concatenate(model), numpy.concatenate(strokes)
    a_centre, b_centre = a.mean(0), b.mean(0)
    scale = ((a - a_centre) * (b - b_centre)).sum(0) / numpy.maximum(((a - a_centre) ** 2).sum(0), 1e-9)
    if not (numpy.all(scale > 0.2) and numpy.all(scale < 3)):
        scale = math.sqrt(((b - b_centre) ** 2).sum() / ((a - a_centre) ** 2).sum())
    return [(stroke - a_centre) * scale + b_centre for stroke in model]


def enlarged(writing, models, least, most, chance):
    """The same hand, steadier or rougher: what each stroke differs from the model by, times a number about the same for
    all of them."""
    model = [numpy.array(sampled(stroke)) for stroke in models[writing["char"]]]
    strokes = [numpy.array(sampled(stroke)) for stroke in writing["strokes"]]
    of_all = chance.uniform(least, most)
    result = []
    for drawn, right in zip(strokes, laid_over(model, strokes), strict=True):
        times = min(most, max(least, of_all + chance.gauss(0, 0.15)))
        result.append((right + times * (drawn - right)).tolist())
    return {"char": writing["char"], "strokes": result}


def rougher_and_steadier(right, models):
    """Other writings of the same hands, for learning only."""
    chance = random.Random(f"enlarged {len(right)}")
    of_many = len(right) > MANY
    known = [w for w in right if len(models.get(w["char"], [])) == len(w["strokes"])]
    bounds = ENLARGED_OF_MANY if of_many else ENLARGED
    return [enlarged(w, models, *bounds, chance) for w in known[:: 2 if of_many else 1] for _ in range(1 if of_many else 5)]


def a_long_stroke(strokes, chance):
    """The index of one of them; None where there is none."""
    long = [i for i, s in enumerate(strokes) if length(s) > 0.25]
    return chance.choice(long) if long else None


def cut(writing, chance):
    """The writing with one long stroke cut to about a third, and which; None where it has no long one."""
    strokes = writing["strokes"]
    k = a_long_stroke(strokes, chance)
    if k is None:
        return None
    points = sampled(strokes[k])[: chance.choice((7, 8, 9))]
    return strokes[:k] + [points] + strokes[k + 1 :], k


def lengthened(writing, chance):
    """The writing with one long stroke drawn longer; None where it has no long one. It is right: that is advice."""
    strokes = writing["strokes"]
    k = a_long_stroke(strokes, chance)
    if k is None:
        return None
    return strokes[:k] + [moved(strokes[k], centre(strokes[k]), chance.uniform(1.2, 1.85))] + strokes[k + 1 :]


def displaced(writing, chance):
    """The writing with one stroke moved by about a fifth of the box, and which."""
    strokes = writing["strokes"]
    k = chance.randrange(len(strokes))
    turn, far = chance.uniform(0, 2 * math.pi), chance.uniform(0.17, 0.26)
    to = [[p[0] + far * math.cos(turn), p[1] + far * math.sin(turn)] for p in strokes[k]]
    return strokes[:k] + [to] + strokes[k + 1 :], k


def samples_of(right, name, of_models=False, most_copies=MOST_COPIES):
    chance = random.Random(name)
    copies = min(most_copies, max(3, COPIES // (20 * len(right))))
    samples = []

    def add(w, strokes, strange, kind):
        samples.append(Sample(w["char"], strokes, strange, False, kind))
        first = 0 if strange is None else strange
        end = chance.randrange(first + 1, len(strokes) + 1)
        if end < len(strokes):
            samples.append(Sample(w["char"], strokes[:end], strange, True, kind))

    for w in right:
        add(w, w["strokes"], None, "right")
        for keep_place, kind in ((False, "reshaped"), (True, "replaced")):
            for _ in range(copies):
                strokes = spoiled(w, right, chance, keep_place)
                if strokes:
                    strange = next(i for i, s in enumerate(strokes) if s is not w["strokes"][i])
                    add(w, strokes, strange, kind)
        if of_models:
            for _ in range(CUTS):
                if short := cut(w, chance):
                    add(w, *short, "cut")
            if long := lengthened(w, chance):
                add(w, long, None, "long")
            if len(w["strokes"]) > 2:
                add(w, *displaced(w, chance), "moved")
    return samples


def measure(program, database, samples):
    lines = []
    for s in samples:
        parts = [str(ord(s.character)), str(int(s.is_beginning)), str(len(s.strokes))]
        for stroke in s.strokes:
            parts.append(str(len(stroke)))
            parts += [f"{p[0]:.5f} {p[1]:.5f}" for p in stroke]
        lines.append(" ".join(parts))
    answer = subprocess.run([program, database], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
    for s, line in zip(samples, answer.stdout.splitlines(), strict=True):
        s.strokes = None
        numbers = numpy.array(line.split(), dtype=numpy.float32)
        if numbers.size == 0:
            continue
        strokes = numbers.reshape(-1, 3 + FEATURES)
        if not numpy.array_equal(strokes[:, 0], strokes[:, 1]):
            continue  # another order: refused whatever the shapes
        s.drawn, s.reversed, s.features = strokes[:, 0], strokes[:, 2], strokes[:, 3:]


def table(samples):
    """Features, whether strange, and weights: right and strange weigh the same."""
    chance = random.Random(1)
    x, y, weight = [], [], []

    def put(features, label, each):
        x.append(features)
        y.extend([label] * len(features))
        weight.extend([each] * len(features))

    for s in samples:
        if s.features is None:
            continue
        each = OF_BEGINNING if s.is_beginning else 1
        if s.strange is None:
            put(s.features, 0, each)
        else:
            strange = s.drawn == s.strange
            put(s.features[strange], 1, each)
            beside = numpy.flatnonzero(~strange)
            put(s.features[chance.sample(list(beside), min(len(beside), MOST_BESIDE))], 0, each * OF_BESIDE)
    y, weight = numpy.array(y), numpy.array(weight, dtype=float)
    for label in (0, 1):
        weight[y == label] /= weight[y == label].sum()
    return numpy.concatenate(x), y, weight


def learned(groups):
    """Trees from groups of writings; each is a list of sets that weigh the same."""
    x, y, weight = [], [], []
    for group in groups:
        scale = (WEIGHT_OF_LARGE if len(group[0]) > LARGE else 1) / len(group)
        for one in group:
            features, labels, weights = table(one)
            x.append(features)
            y.append(labels)
            weight.append(scale * weights)
    x, y, weight = (numpy.concatenate(parts) for parts in (x, y, weight))
    growing = [1 if i in GROWING else 0 for i in range(FEATURES)]
    trees = HistGradientBoostingClassifier(**TREES, monotonic_cst=growing)
    return trees.fit(x, y, sample_weight=weight * len(y) / weight.sum())


def strangest(trees, samples):
    """The log odds of the strangest stroke; infinite where the strokes were not found, or one is drawn backwards."""
    odds = numpy.full(len(samples), numpy.inf)
    known = [i for i, s in enumerate(samples) if s.features is not None]
    answers = trees.decision_function(numpy.concatenate([samples[i].features for i in known]))
    at = 0
    for i in known:
        count = len(samples[i].features)
        if not samples[i].reversed.any():
            odds[i] = answers[at : at + count].max()
        at += count
    return odds


def calibrated(samples, odds):
    """a and b of a + b * odds, right and strange weighing the same. What was not found is refused without the trees."""
    keep = numpy.isfinite(odds)
    y = numpy.array([s.strange is not None for s in samples])[keep]
    weight = numpy.where(y, 0.5 / max(y.sum(), 1), 0.5 / max((~y).sum(), 1)) * len(y)
    fit = LogisticRegression(C=1e6).fit(odds[keep].reshape(-1, 1), y, sample_weight=weight)
    return float(fit.intercept_[0]), float(fit.coef_[0, 0])


def report(name, samples, odds, limit):
    def share(kind):
        return 100 * numpy.mean([o > limit for s, o in zip(samples, odds) if s.kind == kind])

    print(f"{name}: {100 - share('right'):.1f} % accepted, {share('reshaped'):.1f} % of reshaped, {share('replaced'):.1f} % of replaced told")


def nodes_of(trees, a, b):
    """The file of decision_trees.h. The constants go into one more tree."""
    data = struct.pack("<BHf", 255, 0, a + b * float(trees._baseline_prediction.ravel()[0]))
    for predictors in trees._predictors:
        nodes = predictors[0].nodes

        def size(i):
            return 1 if nodes[i]["is_leaf"] else 1 + size(nodes[i]["left"]) + size(nodes[i]["right"])

        def put(i):
            n = nodes[i]
            if n["is_leaf"]:
                return struct.pack("<BHf", 255, 0, b * n["value"])
            return (
                struct.pack("<BHf", n["feature_idx"], 1 + size(n["left"]), n["num_threshold"]) + put(n["left"]) + put(n["right"])
            )

        data += put(0)
    return data


def whole_writings(samples):
    return [s for s in samples if not s.is_beginning]


def other_hands(files, groups, made):
    """For each file its writings, and what is said of them by trees that never saw it."""
    results = []
    for i, file in enumerate(files):
        own = groups[i][0]
        if len(own) > LARGE:  # the others alone are too few: its characters are left out by turns
            inside, rest = without(groups[i], part_of(own, file, 0))
            others = groups[:i] + [rest] + groups[i + 1 :]
        else:
            inside, others = own, groups[:i] + groups[i + 1 :]
        inside = whole_writings(inside)
        results.append((file, inside, strangest(learned(others + [[made]]), inside)))
    return results


def other_characters(files, groups, made):
    """The same by trees that saw other characters of each hand."""
    inside, odds = [[] for _ in files], [[] for _ in files]
    for k in range(PARTS):
        split = [without(group, part_of(group[0], file, k)) for file, group in zip(files, groups)]
        trees = learned([rest for _, rest in split] + [[made]])
        for i, (own, _) in enumerate(split):
            own = whole_writings(own)
            inside[i] += own
            odds[i].append(strangest(trees, own))
    return [(file, inside[i], numpy.concatenate(odds[i])) for i, file in enumerate(files)]


def part_of(samples, file, k):
    """One of PARTS parts of the characters in them."""
    characters = sorted({s.character for s in samples})
    random.Random(file.rsplit("/", 1)[-1]).shuffle(characters)
    return set(characters[k::PARTS])


def without(group, characters):
    """The writings of these characters, and the group without them."""
    inside = [s for s in group[0] if s.character in characters]
    return inside, [[s for s in one if s.character not in characters] for one in group]


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    program, database, output, files = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
    models = models_in(program, database)
    groups = []
    for file in files:
        right, name = writings_of(file), file.rsplit("/", 1)[-1]
        own = samples_of(right, name)
        more = samples_of(rougher_and_steadier(right, models), "enlarged " + name, most_copies=COPIES_OF_ENLARGED)
        measure(program, database, own)
        measure(program, database, more)
        groups.append([own, more])
    made = samples_of(drawn_models(models), "models", of_models=True)
    measure(program, database, made)
    whole = other_hands(files, groups, made)
    a, b = calibrated([s for _, inside, _ in whole for s in inside], numpy.concatenate([o for _, _, o in whole]))
    print(f"calibration: {a:.3f} + {b:.3f} * log odds")
    a -= math.log(RIGHT_TO_STRANGE)
    for what, results in (("other hands", whole), ("other characters of the same hands", other_characters(files, groups, made))):
        for said in (0.3, 0.4, 0.45, 0.5, 0.6):
            limit = numpy.log((1 - said) / said)
            print(f"{what}, accepted from {said}")
            for file, inside, odds in results:
                report("  " + file.rsplit("/", 1)[-1], inside, a + b * odds, limit)
    trees = nodes_of(learned(groups + [[made]]), a, b)
    with open(output, "wb") as out:
        out.write(trees)


if __name__ == "__main__":
    main()
