// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_writing.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "nazori/calligraphy/sheet_export.h"
#include "nazori/calligraphy/teacher_hand.h"

namespace nazori::calligraphy {
namespace {

template <class Value>
void note_error(Outcome& outcome, const base::Result<Value>& result) {
  outcome.failed = !result;
  if (!result) outcome.error = result.error();
}

}  // namespace

/// The sheet, on the other thread.
struct BrushWriting::Work {
  std::optional<SheetEditor> editor = {};
  std::vector<int> changed = {};

  BrushFrame frame() {
    const auto& picture = editor->picture(changed);
    BrushFrame frame{{}, editor->state(), editor->brush_shape()};
    constexpr auto kSide = std::size_t{PictureTile::kSide};
    const int a_side = picture.width / PictureTile::kSide;
    frame.tiles.reserve(changed.size());
    for (const int number : changed) {
      PictureTile& tile = frame.tiles.emplace_back();
      tile.column = number % a_side * PictureTile::kSide;
      tile.row = number / a_side * PictureTile::kSide;
      for (std::size_t y = 0; y < kSide; ++y) {
        const std::size_t from =
            3 * ((static_cast<std::size_t>(tile.row) + y) * static_cast<std::size_t>(picture.width) +
                 static_cast<std::size_t>(tile.column));
        std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(from), 3 * kSide,
                    tile.rgb.begin() + static_cast<std::ptrdiff_t>(3 * kSide * y));
      }
    }
    return frame;
  }
};

BrushWriting::BrushWriting(base::Inbox& inbox, const std::string& paper, int cells)
    : cells_(cells), work_(std::make_shared<Work>()), background_("brush", inbox) {
  // The fibres of the paper take a while, so the other thread makes them.
  background_.post([work = work_.get(), paper, cells] {
    auto made = SheetEditor::create(paper, cells);
    // A paper that is not known, as from a settings file.
    if (!made) made = SheetEditor::create("hanshi", cells);
    work->editor = std::move(made.value());
  });
  request([](SheetEditor&) -> std::optional<Outcome> { return {}; });
}

BrushWriting::~BrushWriting() = default;

/// Lets the other thread do something and answer with a frame, and with an outcome if there is one.
template <class Act>
void BrushWriting::request(Act act) {
  ++waiting_;
  background_.post([this, background = &background_, work = work_.get(), act = std::move(act)]() mutable {
    std::optional<Outcome> outcome = act(*work->editor);
    background->answer([this, frame = work->frame(), outcome = std::move(outcome)] {
      --waiting_;
      state_ = frame.state;
      drawn(frame);
      if (outcome) done(*outcome);
    });
  });
}

/// As request(), after the samples that are waiting.
template <class Act>
void BrushWriting::ask(Act act) {
  flush(0);
  request(std::move(act));
}

void BrushWriting::flush(int steps) {
  if (samples_.empty() && steps == 0) return;
  request([samples = std::exchange(samples_, {}), steps](SheetEditor& editor) -> std::optional<Outcome> {
    const std::size_t each = samples.size() / static_cast<std::size_t>(std::max(steps, 1)) + 1;
    std::size_t next = 0;
    for (int step = 0; step < std::max(steps, 1); ++step) {
      const std::size_t end = step + 1 >= steps ? samples.size() : std::min(next + each, samples.size());
      for (; next < end; ++next) editor.move_pen(samples[next]);
      if (step < steps) editor.step();
    }
    return {};
  });
}

void BrushWriting::move_pen(const brush::PenSample& sample) {
  samples_.push_back(sample);
  last_ = sample;
  is_down_ = sample.is_down();
  rests_ = false;
}

void BrushWriting::lift_pen() {
  if (is_down_) move_pen(last_.lifted());
}

void BrushWriting::tick(double seconds) {
  if (is_down_ && rests_) {
    last_.time_s += seconds;
    samples_.push_back(last_);
  }
  rests_ = true;
  due_s_ += seconds;
  // While the last frame is not finished, the next one would only queue up behind it.
  if (waiting_ > 0) return;
  const int due = static_cast<int>(due_s_ / paint::Sheet::kStep_s);
  due_s_ -= due * paint::Sheet::kStep_s;
  const bool flows = state_.is_wet || is_down_ || !samples_.empty();
  flush(flows ? std::min(due, kMostSteps) : 0);
}

void BrushWriting::set_brush(const BrushChoice& choice) {
  ask([choice](SheetEditor& editor) -> std::optional<Outcome> {
    editor.set_brush(choice);
    return {};
  });
}

void BrushWriting::set_handling(const brush::Handling& handling) {
  ask([handling](SheetEditor& editor) -> std::optional<Outcome> {
    editor.set_handling(handling);
    return {};
  });
}

void BrushWriting::set_ink(const std::string& ink) {
  ask([ink](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::ink};
    note_error(outcome, editor.set_ink(ink));
    return outcome;
  });
}

void BrushWriting::dip_in_ink() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    editor.dip_in_ink();
    return {};
  });
}

void BrushWriting::dip_in_water() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    editor.dip_in_water();
    return {};
  });
}

void BrushWriting::wipe() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    editor.wipe();
    return {};
  });
}

void BrushWriting::undo() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::undo, editor.undo()};
    outcome.changed = outcome.edit != Edit::none;
    return outcome;
  });
}

void BrushWriting::redo() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::redo, editor.redo()};
    outcome.changed = outcome.edit != Edit::none;
    return outcome;
  });
}

void BrushWriting::dry_now() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::dry};
    outcome.changed = editor.dry_now();
    return outcome;
  });
}

void BrushWriting::take_new_sheet(const std::string& paper) {
  ask([paper](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::new_sheet};
    note_error(outcome, editor.take_new_sheet(paper));
    return outcome;
  });
}

void BrushWriting::save(const std::filesystem::path& path) {
  ask([path](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{.task = Task::save, .file = path};
    note_error(outcome, editor.save(path));
    return outcome;
  });
}

void BrushWriting::open(const std::filesystem::path& path) {
  ask([path](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{.task = Task::open, .file = path};
    note_error(outcome, editor.open(path));
    return outcome;
  });
}

void BrushWriting::save_png(const std::filesystem::path& path) {
  ask([path](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{.task = Task::save_png, .file = path};
    note_error(outcome, editor.save_png(path));
    return outcome;
  });
}

void BrushWriting::save_svg(const std::filesystem::path& path) {
  ask([path](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{.task = Task::save_svg, .file = path};
    note_error(outcome, calligraphy::save_svg(editor.written(), path));
    return outcome;
  });
}

void BrushWriting::save_pdf(const std::filesystem::path& path, const std::string& title) {
  ask([path, title](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{.task = Task::save_pdf, .file = path};
    note_error(outcome, calligraphy::save_pdf(editor.sheet(), title, path));
    return outcome;
  });
}

void BrushWriting::advise(std::vector<SheetModel> models, const AdviceOptions& options) {
  ask([models = std::move(models), options](SheetEditor& editor) -> std::optional<Outcome> {
    editor.lift_pen();
    Outcome outcome{Task::advise};
    outcome.advice = calligraphy::advise(editor.written(), ink_on(editor.sheet()), models, options);
    return outcome;
  });
}

void BrushWriting::request_hand(std::vector<ModelStroke> strokes) {
  ask([strokes = std::move(strokes)](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::hand};
    outcome.hand = teacher_hand(strokes, BrushWidths(form_of(editor.brush_choice())));
    return outcome;
  });
}

void BrushWriting::carve() {
  ask([](SheetEditor& editor) -> std::optional<Outcome> {
    Outcome outcome{Task::carve};
    auto carved = editor.carve();
    note_error(outcome, carved);
    if (carved) outcome.tablet = std::move(*carved);
    return outcome;
  });
}

}  // namespace nazori::calligraphy
