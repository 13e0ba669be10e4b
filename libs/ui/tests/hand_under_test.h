// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QTest>
#include <cmath>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::ui::test {

using Points = std::vector<geometry::GlyphPoint>;

/// The strokes of a character, as KanjiVG draws them.
inline std::vector<Points> model(char32_t character) {
  const auto path = std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
  std::vector<Points> strokes;
  for (const auto& line : kanji::KanjiDatabase::open(path)->find(character)->lines())
    strokes.push_back(line.points);
  return strokes;
}

/// The stroke that a hand would have written along a line, with a point every 10 ms, without waiting.
inline practice::HandStroke hand_stroke(const Points& line, double begin_s = 0) {
  practice::HandStroke stroke;
  for (double at = 0; at <= geometry::arc_length<geometry::GlyphFrame>(line); at += 1)
    stroke.push_back({geometry::glyph_to_tablet(geometry::point_at<geometry::GlyphFrame>(line, at), {}),
                      begin_s += 0.01, 0.5});
  return stroke;
}

/// The pen goes along a line on the tablet, at the pace of a hand.
inline void write(practice::TabletControl& controller, const Points& line) {
  const auto put = [&](geometry::GlyphPoint p, bool down) {
    controller.move_stylus(geometry::glyph_to_tablet(p, {}), down);
  };
  put(line.front(), false);
  const auto above = geometry::glyph_to_tablet(line.front(), {});
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const auto& at = controller.latest().device_m;
        return std::hypot(at.x - above.x, at.y - above.y) < 1e-3 && !controller.latest().touching;
      },
      5000));
  put(line.front(), true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return controller.latest().touching; }, 5000));
  const double length = geometry::arc_length<geometry::GlyphFrame>(line);
  for (double at = 0; at <= length; at += 1) {
    put(geometry::point_at<geometry::GlyphFrame>(line, at), true);
    QTest::qWait(3);
  }
  put(line.back(), true);
  QTest::qWait(60);  // the hand rests at the end of a stroke that stops: part of the writing, not of the test
  put(line.back(), false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !controller.latest().touching; }, 5000));
  controller.pump();
}

}  // namespace nazori::ui::test
