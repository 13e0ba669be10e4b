// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/sheet_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>

#include "nazori/base/utf8.h"
#include "paper.h"

namespace nazori::scan {
namespace {

SheetReader& reader() {
  static SheetReader made = *SheetReader::make(database());
  return made;
}

using testing::Contains;
using testing::Each;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

print::SheetSettings plain() {
  print::SheetSettings settings;
  settings.rows = 1;
  settings.steps = settings.facts = false;
  return settings;
}

PaperSheet printed(std::u32string_view text, const print::SheetSettings& settings, int page = 1) {
  return PaperSheet(print::worksheet_pdf(sheet_characters(text), settings), page);
}

/// The cells to write in of a sheet of one character.
std::vector<print::MarkedBox> open_boxes(const PaperSheet& sheet) {
  const auto found = find_sheets(sheet.photographed({}));
  EXPECT_TRUE(found) << (found ? "" : base::to_line(found.error()));
  std::vector<print::MarkedBox> open;
  if (!found) return open;
  for (const print::MarkedBox& box : print::boxes_of(found->front().mark))
    if (!box.traced) open.push_back(box);
  return open;
}

std::vector<CellReading> open_cells(const Photo& photo) {
  const auto read = reader().read(photo);
  EXPECT_TRUE(read) << (read ? "" : base::to_line(read.error()));
  std::vector<CellReading> open;
  if (!read) return open;
  for (const CellReading& cell : read->front().cells)
    if (!cell.box.traced) open.push_back(cell);
  return open;
}

Handwriting model_of(char32_t c) {
  std::mt19937 random(1);
  Handwriting strokes = by_hand(database().find(c).value(), random, 0);
  return strokes;
}

/// The writing moved, made larger and turned around the middle of its cell.
Handwriting changed(Handwriting strokes, double scale, double dx, double dy, double turn_deg = 0) {
  const double turn = turn_deg * std::numbers::pi / 180;
  for (auto& stroke : strokes)
    for (auto& p : stroke) {
      const double x = (p[0] - 0.5) * scale;
      const double y = (p[1] - 0.5) * scale;
      p = {0.5 + x * std::cos(turn) - y * std::sin(turn) + dx,
           0.5 + x * std::sin(turn) + y * std::cos(turn) + dy};
    }
  return strokes;
}

TEST(SheetReader, AnEmptySheetIsEmptyWithEveryGuideAndAtEveryResolution) {
  for (const print::Guide guide :
       {print::Guide::none, print::Guide::cross, print::Guide::field, print::Guide::diagonals}) {
    print::SheetSettings settings = plain();
    settings.guide = guide;
    const PaperSheet sheet = printed(U"休永", settings);
    for (const double dpi :
         guide == print::Guide::cross ? std::vector<double>{100, 300} : std::vector<double>{100}) {
      View view;
      view.dpi = dpi;
      view.noise = 4;
      const auto cells = open_cells(sheet.photographed(view));
      ASSERT_THAT(cells, SizeIs(2 * 8));
      EXPECT_THAT(cells, Each(Field(&CellReading::state, CellState::empty))) << dpi;
    }
  }
}

TEST(SheetReader, SheetsAreFoundTurnedAnyWay) {
  PaperSheet sheet = printed(U"休", plain());
  const auto boxes = open_boxes(sheet);
  sheet.write(boxes[2], model_of(U'休'));
  for (const double turn : {10, -10, 90, 187, 270}) {
    View view;
    view.turn_deg = turn;
    view.light = 0.4;
    view.blur_px = 0.7;
    const auto cells = open_cells(sheet.photographed(view));
    ASSERT_THAT(cells, SizeIs(boxes.size())) << turn;
    for (std::size_t i = 0; i < cells.size(); ++i)
      EXPECT_EQ(cells[i].state, i == 2 ? CellState::legible : CellState::empty) << turn << " " << i;
  }
}

TEST(SheetReader, CornersAreThoseInThePhotograph) {
  const PaperSheet sheet = printed(U"休", plain());
  View view;
  view.dpi = 254;  // 10 pixels a millimetre, around 14 mm of table
  const auto cells = open_cells(sheet.photographed(view));
  const auto boxes = open_boxes(sheet);
  ASSERT_THAT(cells, SizeIs(boxes.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_NEAR(cells[i].corners[0].x, (boxes[i].corner.x + 14) * 10, 2.5);
    EXPECT_NEAR(cells[i].corners[0].y, (boxes[i].corner.y + 14) * 10, 2.5);
    EXPECT_NEAR(cells[i].corners[2].x - cells[i].corners[0].x, 150, 2.5);
  }
}

TEST(SheetReader, AWrongCharacterIsRefusedAndNamed) {
  PaperSheet sheet = printed(U"休木大", plain());
  const auto boxes = open_boxes(sheet);
  std::mt19937 random(2);
  for (std::size_t i = 0; i < boxes.size(); i += 2)
    sheet.write(boxes[i], by_hand(database().find(boxes[i].character).value(), random));
  for (const auto& [i, wrong] : {std::pair{1U, U'体'}, {9U, U'本'}, {17U, U'犬'}})
    sheet.write(boxes[i], by_hand(database().find(wrong).value(), random));
  const auto cells = open_cells(sheet.photographed({.dpi = 200, .blur_px = 0.6}));
  ASSERT_THAT(cells, SizeIs(24));
  for (std::size_t i = 0; i < cells.size(); i += 2) EXPECT_EQ(cells[i].state, CellState::legible) << i;
  for (const auto& [i, wrong] : {std::pair{1U, U'体'}, {9U, U'本'}, {17U, U'犬'}}) {
    EXPECT_EQ(cells[i].state, CellState::illegible) << i;
    EXPECT_EQ(cells[i].looks_like, wrong) << i;
  }
}

TEST(SheetReader, APencilIsReadOnGuideLines) {
  print::SheetSettings settings = plain();
  settings.guide = print::Guide::field;
  PaperSheet sheet = printed(U"十田", settings);
  const auto boxes = open_boxes(sheet);
  // Both have strokes on the guide lines themselves.
  for (const auto& box : boxes) sheet.write(box, model_of(box.character), 0.6, 0.5);
  EXPECT_THAT(open_cells(sheet.photographed({.dpi = 200, .blur_px = 0.6})),
              Each(Field(&CellReading::state, CellState::legible)));
}

TEST(SheetReader, RemarksSayWhatIsOff) {
  PaperSheet sheet = printed(U"休", plain());
  const auto boxes = open_boxes(sheet);
  const Handwriting right = model_of(U'休');
  Handwriting without = right;
  without.erase(without.begin() + 2);
  Handwriting half = right;
  half[2].resize(half[2].size() * 2 / 5);
  const std::vector<std::pair<Handwriting, std::vector<CellRemark>>> cases{
      {right, {}},
      {changed(right, 0.6, 0, 0), {{CellFlaw::small}}},
      {changed(right, 0.8, 0, 0.14), {{CellFlaw::low}}},
      {changed(right, 0.8, -0.14, -0.14), {{CellFlaw::high}, {CellFlaw::left}}},
      {changed(right, 0.8, 0.14, 0), {{CellFlaw::right}}},
      {changed(right, 0.9, 0, 0, 13), {{CellFlaw::leans_right}}},
      {changed(right, 0.9, 0, 0, -13), {{CellFlaw::leans_left}}},
      {half, {{CellFlaw::short_stroke, 3}}}};
  for (std::size_t i = 0; i < cases.size(); ++i) sheet.write(boxes[i], cases[i].first);
  const auto cells = open_cells(sheet.photographed({.dpi = 200, .turn_deg = 3}));
  ASSERT_THAT(cells, SizeIs(8));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(cells[i].state, CellState::legible) << i;
    EXPECT_EQ(cells[i].remarks, cases[i].second)
        << i << ": covered " << testing::PrintToString(cells[i].shape->covered);
  }
}

TEST(SheetReader, AMissingStrokeIsNamed) {
  PaperSheet sheet = printed(U"曜", plain());
  Handwriting without = model_of(U'曜');
  without.erase(without.begin() + 2);  // the bar in 日
  sheet.write(open_boxes(sheet)[0], without);
  const auto cells = open_cells(sheet.photographed({.dpi = 250}));
  EXPECT_EQ(cells[0].state, CellState::legible);
  EXPECT_THAT(cells[0].remarks, testing::ElementsAre(CellRemark{CellFlaw::missing_stroke, 3}));
  EXPECT_EQ(explain(cells[0].remarks.front()), "stroke 3 is missing");
}

TEST(SheetReader, QuizzesAndBothPagesOfABookletAreRead) {
  print::SheetSettings settings = plain();
  settings.layout = print::Layout::quiz;
  PaperSheet quiz = printed(U"休日", settings);
  const auto boxes = open_boxes(quiz);
  ASSERT_FALSE(boxes.empty());
  for (const auto& box : boxes) quiz.write(box, model_of(box.character));
  EXPECT_THAT(open_cells(quiz.photographed({})), Each(Field(&CellReading::state, CellState::legible)));

  settings = plain();
  settings.booklet = true;
  settings.whole_page = true;
  const PaperSheet inside = printed(U"一二三四", settings, 2);
  const auto sheets = find_sheets(inside.photographed({.turn_deg = 5}));
  ASSERT_TRUE(sheets);
  ASSERT_THAT(*sheets, SizeIs(2));
  std::set<int> pages;
  for (const FoundSheet& sheet : *sheets) pages.insert(sheet.mark.page);
  EXPECT_EQ(pages, (std::set{2, 3}));
}

TEST(SheetReader, PartsOfTheStripMayBeDirty) {
  PaperSheet sheet = printed(U"休永", plain());
  const print::PaperPoint strip = print::module_centre(297, 20, 2);
  sheet.cover(strip.x, strip.y, 3, 2, 40);
  EXPECT_THAT(open_boxes(sheet), SizeIs(16));
}

TEST(SheetReader, ADamagedOrForeignMarkIsAClearError) {
  PaperSheet sheet = printed(U"休永", plain());
  const print::PaperPoint strip = print::module_centre(297, 0, 1);
  std::mt19937 random(1);
  for (int column = 0; column < 60; ++column)
    for (int row = 0; row < print::kMarkRows; ++row)
      sheet.cover(strip.x + (column - 0.5) * print::kModule_mm, strip.y + (row - 0.5) * print::kModule_mm,
                  print::kModule_mm, print::kModule_mm, random() % 2 == 0 ? 255 : 0);
  auto read = reader().read(sheet.photographed({}));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, base::Errc::parse);
  EXPECT_THAT(read.error().what, HasSubstr("the mark cannot be read"));
  sheet.cover(10, 10, 8, 8, 255);  // a disc is gone
  read = reader().read(sheet.photographed({}));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, base::Errc::not_found);
  Photo white{400, 300, std::vector<std::uint8_t>(400 * 300, 255)};
  EXPECT_EQ(find_sheets(white).error().code, base::Errc::not_found);
}

/// How many cells of random photographs were told rightly.
struct Tally {
  int photos = 0, found = 0;
  int right = 0, right_accepted = 0;
  int wrong = 0, wrong_refused = 0;
  int blank = 0, blank_told = 0;
};

TEST(RandomPhotographs, AreReadWithFewMistakes) {
  const char* rounds_text = std::getenv("NAZORI_SCAN_ROUNDS");
  const int rounds = rounds_text != nullptr ? std::atoi(rounds_text) : 2;
  const bool talk = rounds_text != nullptr;
  const auto samples = real_handwriting();
  Tally tally;
  std::set<std::string> spoiled;
  for (int round = 0; round < rounds; ++round) {
    std::mt19937 random(static_cast<unsigned>(round) + 7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    print::SheetSettings settings;
    settings.cell_mm = 12 + 3 * (round % 3);
    settings.guide = static_cast<print::Guide>(round % 4);
    settings.rows = 1;
    settings.steps = false;
    settings.vertical = round % 5 == 4;
    std::u32string text;
    while (text.size() < 5) {
      const char32_t c = samples[random() % samples.size()].character;
      if (text.find(c) == std::u32string::npos && database().draws(c)) text += c;
    }
    PaperSheet sheet(print::worksheet_pdf(sheet_characters(text), settings));
    const auto clean = find_sheets(sheet.photographed({}));
    ASSERT_TRUE(clean) << round << base::to_line(clean.error());
    const auto boxes = print::boxes_of(clean->front().mark);
    std::vector<char32_t> wrote(boxes.size());
    const bool pencil = random() % 2 == 0;
    const double pen_mm = pencil ? 0.6 : 0.5 + 0.3 * std::abs(uniform(random));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].traced || random() % 4 == 0) continue;
      const bool wrong = random() % 4 == 0;
      std::vector<const WrittenSample*> fitting;
      for (const WrittenSample& s : samples)
        if ((s.character == boxes[i].character) != wrong) fitting.push_back(&s);
      const WrittenSample& s = *fitting[random() % fitting.size()];
      wrote[i] = s.character;
      sheet.write(boxes[i], s.strokes, pen_mm, pencil ? 0.5 : 0.88);
    }
    View view;
    view.dpi = 100 + 100 * (1 + uniform(random));
    view.turn_deg = 10 * uniform(random) + 90 * static_cast<int>(random() % 4);
    view.tilt_x = 0.15 * uniform(random);
    view.tilt_y = 0.15 * uniform(random);
    view.curl_mm = uniform(random);
    view.blur_px = 0.4 * (1 + uniform(random)) * view.dpi / 150;
    view.noise = 3 * (1 + uniform(random));
    view.light = 0.25 * (1 + uniform(random));
    ++tally.photos;
    const auto read = reader().read(sheet.photographed(view, static_cast<unsigned>(round)));
    if (!read) {
      if (talk)
        std::printf("round %d not found: %.0f dpi turn %.0f blur %.2f light %.2f: %s\n", round, view.dpi,
                    view.turn_deg, view.blur_px, view.light, base::to_line(read.error()).c_str());
      continue;
    }
    ++tally.found;
    EXPECT_EQ(print::boxes_of(read->front().mark), boxes);
    for (std::size_t i = 0; i < boxes.size() && i < read->front().cells.size(); ++i) {
      const CellReading& cell = read->front().cells[i];
      if (boxes[i].traced) continue;
      const bool is_right = wrote[i] == boxes[i].character;
      bool good = false;
      if (wrote[i] == 0) {
        ++tally.blank;
        tally.blank_told += (good = cell.state == CellState::empty) ? 1 : 0;
      } else if (is_right) {
        ++tally.right;
        tally.right_accepted += (good = cell.state == CellState::legible) ? 1 : 0;
      } else {
        ++tally.wrong;
        tally.wrong_refused += (good = cell.state == CellState::illegible) ? 1 : 0;
      }
      if (!good && talk)
        std::printf(
            "round %d cell %zu asked %s wrote %s: %s like %s, missing %.2f extra %.2f (%.0f dpi blur %.2f "
            "%s)\n",
            round, i, base::encode_utf8(boxes[i].character).c_str(),
            wrote[i] != 0 ? base::encode_utf8(wrote[i]).c_str() : "-",
            kCellStates[static_cast<std::size_t>(cell.state)],
            cell.looks_like ? base::encode_utf8(*cell.looks_like).c_str() : "-",
            cell.shape ? cell.shape->missing : -1, cell.shape ? cell.shape->extra : -1, view.dpi,
            view.blur_px, pencil ? "pencil" : "pen");
    }
  }
  std::printf(
      "%d of %d photographs found; accepted %d of %d right characters; refused %d of %d wrong ones; told %d "
      "of %d "
      "empty cells\n",
      tally.found, tally.photos, tally.right_accepted, tally.right, tally.wrong_refused, tally.wrong,
      tally.blank_told, tally.blank);
  EXPECT_GE(tally.found, tally.photos * 95 / 100);
  EXPECT_GE(tally.right_accepted, tally.right * 85 / 100);
  EXPECT_GE(tally.wrong_refused, tally.wrong * 90 / 100);
  EXPECT_GE(tally.blank_told, tally.blank * 98 / 100);
}

}  // namespace
}  // namespace nazori::scan
