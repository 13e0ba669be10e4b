// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_writing.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "nazori/paint/sheet_file.h"
#include "writing_under_test.h"

namespace nazori::calligraphy {
namespace {

namespace fs = std::filesystem;

/// Ink, paper and brush; the times of the strokes are those of the pen.
std::vector<std::uint8_t> ink_of(const SheetEditor& editor) {
  return paint::to_bytes(editor.sheet(), editor.load());
}
std::vector<std::uint8_t> ink_of(const fs::path& file) {
  const auto saved = paint::load_sheet(file);
  return saved ? paint::to_bytes(saved->sheet, saved->load) : std::vector<std::uint8_t>{};
}

class BrushWritingTest : public testing::Test {
 protected:
  BrushWritingTest() {
    writing_.drawn.connect([this](const BrushFrame& frame) {
      ++frames_;
      tiles_ += static_cast<int>(frame.tiles.size());
      if (!frame.tiles.empty()) last_tile_ = frame.tiles.back();
      brush_ = frame.brush;
    });
    writing_.done.connect([this](const Outcome& outcome) { outcomes_.push_back(outcome); });
    wait_for_frames(1);
  }

  void wait_for_frames(int count) {
    inbox_.run_until([&] { return frames_ >= count; });
  }
  /// Waits until everything that was asked for is done.
  void settle() {
    writing_.set_handling({});
    inbox_.run_until([&] { return !writing_.is_waiting(); });
  }
  const Outcome& outcome() {
    inbox_.run_until([&] { return !outcomes_.empty(); });
    last_ = outcomes_.front();
    outcomes_.erase(outcomes_.begin());
    return last_;
  }

  void line(double y, int samples = 40) {
    for (int i = 0; i <= samples; ++i) {
      brush::PenSample sample;
      sample.time_s = time_s_ += 0.01;
      sample.at = {-0.03 + 0.06 * i / samples, y};
      sample.pressure = 0.6;
      writing_.move_pen(sample);
    }
    writing_.lift_pen();
  }

  base::Inbox inbox_;
  BrushWriting writing_{inbox_, "hanshi", 128};
  int frames_ = 0;
  int tiles_ = 0;
  double time_s_ = 0;
  PictureTile last_tile_;
  BrushShape brush_;
  std::vector<Outcome> outcomes_;
  Outcome last_;
};

TEST_F(BrushWritingTest, TheHandOfATeacherIsMadeForTheBrushInUse) {
  const auto strokes = strokes_of({test::three(), only_square()});
  const auto hardest = [&] {
    writing_.request_hand(strokes);
    const Outcome& made = outcome();
    EXPECT_EQ(made.task, Task::hand);
    double pressure = 0;
    for (const auto& sample : made.hand) pressure = std::max(pressure, sample.pressure.value_or(0));
    return pressure;
  };
  writing_.set_brush({BrushSize::large, brush::Hair::mixed});
  const double thick = hardest();
  writing_.set_brush({BrushSize::medium, brush::Hair::mixed});
  EXPECT_GT(hardest(), thick) << "a thinner brush must be pressed harder";
  EXPECT_EQ(writing_.state().strokes, 0) << "nothing is written yet";
}

TEST_F(BrushWritingTest, BeginsWithThePictureOfAnEmptySheet) {
  EXPECT_EQ(tiles_, 16);  // 4 x 4 of 32 pixels
  EXPECT_EQ(last_tile_.column, 96);
  EXPECT_EQ(last_tile_.row, 96);
  EXPECT_GT(last_tile_.rgb[0], 200);
  EXPECT_GT(last_tile_.rgb.back(), 200);
  EXPECT_EQ(writing_.state().paper, "hanshi");
  EXPECT_EQ(writing_.state().fullness, 1);
  EXPECT_FALSE(writing_.is_busy());
}

TEST_F(BrushWritingTest, APaperThatThereIsNotIsReplaced) {
  BrushWriting other(inbox_, "parchment", 128);
  bool came = false;
  other.drawn.connect([&](const BrushFrame&) { came = true; });
  inbox_.run_until([&] { return came; });
  EXPECT_EQ(other.state().paper, "hanshi");
}

TEST_F(BrushWritingTest, WithNothingToDoATickAsksForNothing) {
  writing_.tick(0.1);
  EXPECT_FALSE(writing_.is_busy());
  settle();
  EXPECT_EQ(frames_, 2);
}

TEST_F(BrushWritingTest, SamplesAreWrittenByTheNextTick) {
  line(0);
  EXPECT_TRUE(writing_.is_busy());
  EXPECT_EQ(writing_.state().strokes, 0);
  writing_.tick(1.0 / 60);
  wait_for_frames(2);
  EXPECT_EQ(writing_.state().strokes, 1);
  EXPECT_TRUE(writing_.state().is_wet);
  EXPECT_TRUE(writing_.is_busy());
  EXPECT_NEAR(brush_.pen.x, 0.03, 1e-9);
}

TEST_F(BrushWritingTest, InkSpreadsAndDriesByTicksAlone) {
  line(0);
  writing_.tick(1.0 / 60);
  wait_for_frames(2);
  const int before = tiles_;
  for (int i = 0; i < 30; ++i) {
    writing_.tick(1.0 / 60);
    wait_for_frames(3 + i);
  }
  EXPECT_GT(tiles_, before);
}

TEST_F(BrushWritingTest, WhileAFrameIsUnderWayTicksDoNotQueueUp) {
  line(0);
  for (int i = 0; i < 50; ++i) writing_.tick(1.0 / 60);
  settle();
  // The first tick's frame, and that of settle().
  EXPECT_EQ(frames_, 3);
  writing_.tick(0);
  wait_for_frames(4);
  EXPECT_EQ(frames_, 4);
}

TEST_F(BrushWritingTest, TheSameTimeInOnePieceOrManyIsTheSameSheet) {
  const auto path = fs::path(testing::TempDir()) / "brush_pieces";
  fs::create_directories(path);
  BrushWriting other(inbox_, "hanshi", 128);
  int others = 0;
  other.drawn.connect([&](const BrushFrame&) { ++others; });
  inbox_.run_until([&] { return others == 1; });
  line(0);
  for (int i = 0; i <= 40; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.01 * (i + 1);
    sample.at = {-0.03 + 0.06 * i / 40, 0};
    sample.pressure = 0.6;
    other.move_pen(sample);
  }
  other.lift_pen();
  writing_.dip_in_ink();  // sends what was written
  other.dip_in_ink();
  wait_for_frames(3);
  inbox_.run_until([&] { return others == 3; });
  writing_.tick(4.01 / 60);
  wait_for_frames(4);
  for (int i = 0; i < 4; ++i) {
    other.tick(1.002 / 60);
    inbox_.run_until([&] { return others == 4 + i; });
  }
  writing_.save(path / "a.nzs");
  other.save(path / "b.nzs");
  bool saved = false;
  other.done.connect([&](const Outcome&) { saved = true; });
  inbox_.run_until([&] { return saved && !outcomes_.empty(); });
  EXPECT_EQ(ink_of(path / "a.nzs"), ink_of(path / "b.nzs"));
  fs::remove_all(path);
}

TEST_F(BrushWritingTest, ADeviceThatIsTakenAwayBelowThePaperIsLifted) {
  brush::PenSample sample;
  sample.time_s = 0.01;
  sample.height_m = -0.004;
  writing_.move_pen(sample);
  writing_.tick(1.0 / 60);
  inbox_.run_until([this] { return writing_.state().is_writing; });
  EXPECT_TRUE(writing_.is_busy());
  writing_.lift_pen();
  writing_.dip_in_ink();
  inbox_.run_until([this] { return !writing_.is_waiting(); });
  EXPECT_FALSE(writing_.state().is_writing);
  EXPECT_EQ(writing_.state().strokes, 1);
}

TEST_F(BrushWritingTest, WithoutATickNoTimePasses) {
  SheetEditor editor = std::move(SheetEditor::create("hanshi", 128).value());
  for (int i = 0; i <= 40; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.01 * (i + 1);
    sample.at = {-0.03 + 0.06 * i / 40, 0};
    sample.pressure = 0.6;
    editor.move_pen(sample);
  }
  editor.lift_pen();
  editor.wipe();
  line(0);
  writing_.wipe();
  const auto path = fs::path(testing::TempDir()) / "brush_no_time.nzs";
  writing_.save(path);
  outcome();
  EXPECT_EQ(ink_of(path), ink_of(editor));
  fs::remove(path);
}

TEST_F(BrushWritingTest, InALateTickInkSpreadsWhileItIsWritten) {
  SheetEditor editor = std::move(SheetEditor::create("hanshi", 128).value());
  line(0);
  int count = 0;
  for (int i = 0; i <= 40; ++i) {
    brush::PenSample sample;
    sample.time_s = 0.01 * (i + 1);
    sample.at = {-0.03 + 0.06 * i / 40, 0};
    sample.pressure = 0.6;
    editor.move_pen(sample);
    // A quarter of the samples before each of four steps.
    if (++count % 11 == 0) editor.step();
  }
  editor.lift_pen();
  editor.step();
  writing_.tick(4.01 / 60);
  const auto path = fs::path(testing::TempDir()) / "brush_late.nzs";
  writing_.save(path);
  outcome();
  EXPECT_EQ(ink_of(path), ink_of(editor));
  fs::remove(path);
}

TEST_F(BrushWritingTest, AfterALongPauseOnlyAFewStepsAreMadeUpFor) {
  line(0);
  writing_.tick(1.0 / 60);
  wait_for_frames(2);
  writing_.tick(3600);
  wait_for_frames(3);
  EXPECT_TRUE(writing_.state().is_wet);  // an hour would have dried it
}

TEST_F(BrushWritingTest, APenThatRestsGoesOnPressing) {
  brush::PenSample sample;
  sample.time_s = 1;
  writing_.move_pen(sample);
  // Without pressure it is guessed from speed and grows while the pen rests, so more and more ink flows.
  writing_.tick(1.0 / 60);
  wait_for_frames(2);
  EXPECT_TRUE(brush_.touches);
  const double full = writing_.state().fullness;
  for (int i = 0; i < 20; ++i) {
    writing_.tick(1.0 / 60);
    wait_for_frames(3 + i);
  }
  EXPECT_TRUE(brush_.touches);
  EXPECT_TRUE(writing_.state().is_wet);
  EXPECT_LT(writing_.state().fullness, full);
  writing_.lift_pen();
  writing_.tick(1.0 / 60);
  wait_for_frames(23);
  EXPECT_FALSE(writing_.state().is_writing);
  EXPECT_EQ(writing_.state().strokes, 1);
}

TEST_F(BrushWritingTest, LiftingAPenThatIsNotDownDoesNothing) {
  writing_.lift_pen();
  EXPECT_FALSE(writing_.is_busy());
}

TEST_F(BrushWritingTest, TimeGoesOnUntilWhatWasAskedForIsAnswered) {
  writing_.dip_in_water();
  EXPECT_TRUE(writing_.is_waiting());
  EXPECT_TRUE(writing_.is_busy());
  settle();
  EXPECT_FALSE(writing_.is_waiting());
  EXPECT_FALSE(writing_.is_busy());
}

TEST_F(BrushWritingTest, UndoAndRedoSayWhatTheyDid) {
  line(0);
  writing_.undo();
  EXPECT_EQ(outcome().task, Task::undo);
  EXPECT_EQ(last_.edit, Edit::stroke);
  EXPECT_TRUE(last_.changed);
  EXPECT_EQ(writing_.state().strokes, 0);
  writing_.undo();
  EXPECT_EQ(outcome().edit, Edit::none);
  EXPECT_FALSE(last_.changed);
  writing_.redo();
  EXPECT_EQ(outcome().task, Task::redo);
  EXPECT_EQ(last_.edit, Edit::stroke);
  EXPECT_EQ(writing_.state().strokes, 1);
  writing_.redo();
  EXPECT_FALSE(outcome().changed);
}

TEST_F(BrushWritingTest, ToolsChangeTheBrush) {
  writing_.dip_in_water();
  settle();
  EXPECT_NEAR(writing_.state().strength, 0.5, 1e-6);
  writing_.wipe();
  settle();
  EXPECT_NEAR(writing_.state().fullness, 0.5, 1e-6);
  writing_.dip_in_ink();
  settle();
  EXPECT_EQ(writing_.state().fullness, 1);
  writing_.set_brush({BrushSize::fine, brush::Hair::goat});
  settle();
  EXPECT_EQ(writing_.state().brush, (BrushChoice{BrushSize::fine, brush::Hair::goat}));
  writing_.set_ink("vermilion");
  EXPECT_EQ(outcome().task, Task::ink);
  EXPECT_FALSE(last_.failed);
  EXPECT_EQ(writing_.state().ink, "vermilion");
  writing_.set_ink("green");
  EXPECT_TRUE(outcome().failed);
  EXPECT_EQ(last_.error.code, base::Errc::not_found);
}

TEST_F(BrushWritingTest, DryingAndNewSheets) {
  writing_.dry_now();
  EXPECT_EQ(outcome().task, Task::dry);
  EXPECT_FALSE(last_.changed);
  line(0);
  writing_.dry_now();
  EXPECT_TRUE(outcome().changed);
  EXPECT_FALSE(writing_.state().is_wet);
  writing_.take_new_sheet("board");
  EXPECT_EQ(outcome().task, Task::new_sheet);
  EXPECT_FALSE(last_.failed);
  EXPECT_EQ(writing_.state().paper, "board");
  writing_.take_new_sheet("parchment");
  EXPECT_TRUE(outcome().failed);
  EXPECT_EQ(writing_.state().paper, "board");
}

TEST_F(BrushWritingTest, FilesAreWrittenAndReadAndErrorsReported) {
  const auto folder = fs::path(testing::TempDir()) / "brush_writing";
  fs::create_directories(folder);
  line(0);
  writing_.save(folder / "a.nzs");
  EXPECT_EQ(outcome().task, Task::save);
  EXPECT_FALSE(last_.failed);
  EXPECT_EQ(last_.file, folder / "a.nzs");
  EXPECT_TRUE(writing_.state().is_saved);
  writing_.save_png(folder / "a.png");
  EXPECT_EQ(outcome().task, Task::save_png);
  EXPECT_TRUE(fs::exists(folder / "a.png"));
  writing_.take_new_sheet("board");
  outcome();
  writing_.open(folder / "a.nzs");
  EXPECT_EQ(outcome().task, Task::open);
  EXPECT_FALSE(last_.failed);
  EXPECT_EQ(writing_.state().paper, "hanshi");
  writing_.open(folder / "missing.nzs");
  EXPECT_TRUE(outcome().failed);
  EXPECT_EQ(last_.file, folder / "missing.nzs");
  writing_.save(folder / "no" / "a.nzs");
  EXPECT_TRUE(outcome().failed);
  writing_.save_png(folder / "no" / "a.png");
  EXPECT_TRUE(outcome().failed);
  fs::remove_all(folder);
}

TEST_F(BrushWritingTest, StrokesAreSavedAsSvgAndTheSheetAsPdf) {
  const fs::path folder = fs::path(testing::TempDir()) / "drawings";
  fs::create_directories(folder);
  writing_.save_svg(folder / "a.svg");
  EXPECT_TRUE(outcome().failed);
  line(0);
  writing_.save_svg(folder / "a.svg");
  EXPECT_EQ(outcome().task, Task::save_svg);
  EXPECT_FALSE(last_.failed);
  EXPECT_TRUE(fs::exists(folder / "a.svg"));
  writing_.save_pdf(folder / "a.pdf", "a");
  EXPECT_EQ(outcome().task, Task::save_pdf);
  EXPECT_FALSE(last_.failed);
  EXPECT_TRUE(fs::exists(folder / "a.pdf"));
  fs::remove_all(folder);
}

TEST_F(BrushWritingTest, AdviceIsAboutWhatIsWrittenAndChangesNothing) {
  line(0);
  const std::vector<SheetModel> models{{test::three(), only_square()}, {test::rest(), ruled_squares(6)[5]}};
  writing_.advise(models, {});
  EXPECT_EQ(outcome().task, Task::advise);
  ASSERT_EQ(last_.advice.size(), 2U);
  EXPECT_EQ(last_.advice[0].character, U'三');
  EXPECT_EQ(last_.advice[0].written, 1);
  EXPECT_EQ(last_.advice[1].written, 0);
  EXPECT_EQ(writing_.state().strokes, 1);
}

TEST_F(BrushWritingTest, TheSheetIsCarved) {
  line(0);
  writing_.carve();
  EXPECT_EQ(outcome().task, Task::carve);
  ASSERT_NE(last_.tablet, nullptr);
  EXPECT_LT(last_.tablet->height_map().at(64, 64), 0.75F);
}

TEST(BrushWritingEnds, WhileMuchIsAskedFor) {
  base::Inbox inbox;
  {
    BrushWriting writing(inbox, "hanshi", 128);
    for (int i = 0; i < 20; ++i) writing.dip_in_water();
  }
  // Answers that come too late are dropped.
  while (inbox.run_one()) {
  }
}

}  // namespace
}  // namespace nazori::calligraphy
