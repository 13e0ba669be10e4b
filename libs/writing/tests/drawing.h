// SPDX-License-Identifier: Apache-2.0
// Ink made from models, and what a hand does to it.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/ink.h"

namespace nazori::writing::test {

/// A character from SVG path data of its strokes, each "type|path".
kanji::Character character(char32_t code_point, const std::vector<std::string>& strokes);

// KanjiVG 20220427 (Ulrich Apel, CC BY-SA 3.0), the strokes of main forms.
kanji::Character rest();  // 休
kanji::Character soil();  // 土
/// 土 with its bars exchanged: the lower one is the shorter one.
kanji::Character samurai();  // 士
kanji::Character three();    // 三
kanji::Character eye();      // 目

/// The model's own lines, in the box of the model.
Ink trace(const kanji::Character& character);

/// The first `share` of the length.
InkStroke shortened(const InkStroke& stroke, double share);
/// Both without lifting the pen.
InkStroke joined(const InkStroke& first, const InkStroke& second);
InkStroke reversed(InkStroke stroke);
/// `count` points at even steps.
InkStroke resampled(const InkStroke& stroke, std::size_t count);

/// Every point through x' = a x + b y + e, y' = c x + d y + f; the box is forgotten.
Ink mapped(Ink ink, double a, double b, double c, double d, double e, double f);
/// Every point moved by a normal deviate of `sigma`.
Ink shaken(Ink ink, double sigma, std::uint32_t seed);

/// Mistakes as "order@1": kind and stroke from 0.
std::vector<std::string> mistake_names(const Grade& grade);

/// grade() that must succeed.
Grade graded(const Ink& ink, const Model& model, double strictness = kNormal);

/// A model that must succeed.
Model model_of(const kanji::Character& character);

}  // namespace nazori::writing::test
