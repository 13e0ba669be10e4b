// SPDX-License-Identifier: Apache-2.0
// Writing made from models, and what a hand does to it.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/written_character.h"

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
WrittenCharacter trace(const kanji::Character& character);

/// A stroke along a line; times and pressures of its first points, where given.
WrittenStroke along(const geometry::Polyline<WritingFrame>& line, const std::vector<double>& times_s = {},
                    const std::vector<double>& pressures = {});

/// The first `share` of the length.
WrittenStroke shortened(const WrittenStroke& stroke, double share);
/// Both strokes without lifting the pen.
WrittenStroke joined(const WrittenStroke& first, const WrittenStroke& second);
WrittenStroke reversed(WrittenStroke stroke);
/// `count` points at equal steps.
WrittenStroke resampled(const WrittenStroke& stroke, std::size_t count);

/// Every point through x' = a x + b y + e, y' = c x + d y + f; the box is forgotten.
WrittenCharacter mapped(WrittenCharacter ink, double a, double b, double c, double d, double e, double f);
/// Every point moved by a normal deviate of `sigma`.
WrittenCharacter shaken(WrittenCharacter ink, double sigma, std::uint32_t seed);

/// Mistakes as "order@1": kind and stroke from 0.
std::vector<std::string> mistake_names(const Grade& grade);

/// grade() that must succeed.
Grade graded(const WrittenCharacter& ink, const Model& model, double strictness = kNormal);

/// A model that must succeed.
Model model_of(const kanji::Character& character);

}  // namespace nazori::writing::test
