// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/correction.h"
#include "nazori/practice/pen_recorder.h"
#include "nazori/practice/tablet_control.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/practice/writing_judge.h"

namespace nazori::practice {

/// A character as it is being written on the tablet: the strokes of the pen, what the judge answered about
/// them, and which strokes of the model are shown as help. A stage decides what is said of it and when it is
/// over. Between begin() and end() it listens to the pen. Thread: the owner of the inbox.
class WritingAttempt {
 public:
  /// All that was written, so that it can be put aside and brought back.
  struct Content {
    std::vector<HandStroke> strokes;
    writing::Grade grade;     ///< the newest; its strokes may lag behind what is written
    PenReport pen;            ///< of the writing that was judged last as a whole
    std::vector<bool> seen;   ///< strokes whose verdict the learner may see
    std::vector<int> hinted;  ///< strokes of the model that are shown, from 0
    int hints = 0;            ///< asked for since the last stroke
  };
  /// What is drawn beside the strokes.
  struct Look {
    std::optional<double>
        moment_s;             ///< the writing as it was so long after its beginning; nothing: all of it
    bool model_over = false;  ///< the whole model lies over the writing
    bool fits_model = true;   ///< the model is moved and sized to lie over what is written
    std::vector<Correction::Part> correction = {};  ///< right strokes that are being drawn over the writing
  };
  /// What a hint shows.
  enum class Hint : std::uint8_t {
    none_missing,  ///< every stroke is there
    next,          ///< the next stroke
    all,           ///< all that are missing, at the second time
  };

  /// @param tablet, judge  outlive this.
  WritingAttempt(TabletControl& tablet, WritingJudge& judge);

  /// Begins with nothing written. @param character  0: nothing is judged. @param model  null: no model.
  void begin(char32_t character, Tablet model);
  /// Nothing is written or answered any more; what is written is gone.
  void end();
  /// Begins the same character again.
  void clear();
  /// Goes on with what was put aside.
  void restore(Content content) {
    content_ = std::move(content);
    tried_ = content_.strokes;
  }
  /// What is written, which is gone here.
  [[nodiscard]] Content take() { return std::exchange(content_, {}); }

  [[nodiscard]] const Content& content() const { return content_; }
  [[nodiscard]] const std::vector<HandStroke>& strokes() const { return content_.strokes; }
  [[nodiscard]] const writing::Grade& grade() const { return content_.grade; }
  [[nodiscard]] bool is_empty() const { return content_.strokes.empty(); }
  [[nodiscard]] bool is_full() const { return content_.strokes.size() >= writing::kMaxInkStrokes; }
  /// Strokes of the model.
  [[nodiscard]] int stroke_count() const;
  /// Whether an answer of the judge is still to come.
  [[nodiscard]] bool is_judging() const { return awaited_ != 0; }
  /// Whether it is still to be found out if another character was written.
  [[nodiscard]] bool is_naming() const { return naming_ != 0; }
  /// As many strokes as the model has, and none of them wrong or missing.
  [[nodiscard]] bool is_complete() const;
  /// Strokes of the model that are not written, from 0.
  [[nodiscard]] std::vector<int> missing() const;
  /// Strokes of the model that are written right, from 0.
  [[nodiscard]] std::vector<int> right_strokes() const;

  /// 0..1; takes effect with the next question.
  void set_strictness(double strictness) { strictness_ = strictness; }
  /// Whether the verdicts of all strokes may be seen.
  void show_verdicts(bool on) { content_.seen.assign(content_.strokes.size(), on); }

  /// A stroke was written; a refused one before it goes. `checked` follows.
  void add(HandStroke stroke, bool shows_verdict);
  /// The last stroke goes when another is written.
  void refuse_last(bool on) { is_refused_ = on; }
  void drop_refused();
  /// Takes back the stroke being written, or the last one. @return false where there is none.
  bool undo(bool shows_verdicts);
  /// Asks the judge: `checked` follows, or `judged` for the writing as a whole.
  void ask(bool as_a_whole);
  /// Answers that are still to come are not about what is written now.
  void ignore_answers();
  Hint give_hint();
  /// Shows these strokes of the model, from 0.
  void show_model_strokes(std::vector<int> strokes) { content_.hinted = std::move(strokes); }
  /// Shows all of the model, as the answer.
  void show_answer();

  /// Draws it on the tablet.
  void show(const Look& look) const;

  /// The pen was lifted at the end of a stroke.
  base::Signal<const HandStroke&> stroke_ended;
  /// The stroke being written has grown, or has ended.
  base::Signal<> pen_moved;
  /// The other end of the pen touched the tablet.
  base::Signal<> eraser_used;
  /// The judge answered about the strokes so far. The value: it is the first answer since one was added.
  base::Signal<bool> checked;
  /// The judge answered about the writing as a whole.
  base::Signal<> judged;
  base::Signal<const base::Error&> failed;
  /// Another character was written than the one that was asked for: which, the one asked for, and whether the
  /// writing was judged as a whole. It may come after begin() with the next character.
  base::Signal<char32_t, char32_t, bool> other_written;

 private:
  void record(std::span<const haptics::ServoSample> samples);
  void use_grade(std::uint64_t number, const writing::Grade& grade);
  void use_error(std::uint64_t number, const base::Error& error);
  void use_name(std::uint64_t number, char32_t character);
  /// Finds out whether another character is written, where the grade lets one suspect it.
  void name_other(bool as_a_whole);

  TabletControl& tablet_;
  WritingJudge& judge_;
  char32_t character_ = 0;
  Tablet model_;
  double strictness_ = writing::kNormal;
  PenRecorder recorder_;
  Content content_;
  std::vector<HandStroke> tried_;  ///< as they were written, also those that a lesson refused
  std::uint64_t naming_ = 0;       ///< number of the request until it is answered
  char32_t named_for_ = 0;         ///< the character that was asked for then
  bool names_whole_ = false;
  std::uint64_t live_number_ = 0;
  std::uint64_t whole_number_ = 0;
  std::uint64_t awaited_ = 0;   ///< number of the newest request until it is answered
  bool awaits_report_ = false;  ///< the answer to come is about a stroke just written
  bool is_refused_ = false;
  bool is_open_ = false;  ///< between begin() and end()
  base::Connection judged_, failed_, named_, reported_, pressed_, sampled_, erased_;
};

}  // namespace nazori::practice
