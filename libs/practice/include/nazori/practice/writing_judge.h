// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/character_source.h"
#include "nazori/writing/grade.h"
#include "nazori/writing/motion_remarks.h"
#include "nazori/writing/recogniser.h"
#include "nazori/writing/written_character.h"

namespace nazori::practice {

/// The settings for grading a writing.
struct JudgeRequest {
  char32_t character = 0;  ///< the requested one
  writing::WrittenCharacter ink;
  double strictness = writing::kNormal;
  bool finished = true;  ///< false: stroke by stroke, more may follow
};

/// The motion of the pen, and remarks about it.
struct PenReport {
  std::vector<writing::PenMotion> motions;
  std::vector<writing::MotionRemark> remarks;
};

/// A character that was drawn perhaps, and what tells it from those that look like it (カ and 力).
struct FoundCharacter {
  char32_t character = 0;
  double likeness = 0;  ///< 1 for the model itself, towards 0 for anything else
  std::string meaning;  ///< first English meaning, empty for kana and letters
  std::string reading;  ///< first reading, empty for kana and letters

  friend bool operator==(const FoundCharacter&, const FoundCharacter&) = default;
};

/// Grades and recognises writing on separate threads: requests return at once, answers come as signals. Of
/// several requests of one kind only the newest is answered. The recogniser loads all characters at the first
/// request. Thread: the owner of the inbox.
class WritingJudge {
 public:
  /// @param inbox  outlives this.
  WritingJudge(base::Inbox& inbox, const CharacterSource& source);
  ~WritingJudge();
  WritingJudge(const WritingJudge&) = delete;
  WritingJudge& operator=(const WritingJudge&) = delete;

  /// @return the number that comes back with the answer.
  std::uint64_t judge(const JudgeRequest& request);
  /// Requests candidates: characters that are complete and characters that continue, the likeliest of both in
  /// turn.
  /// @return the number that comes back with the answer. @param limit  most candidates, >= 1. @param among
  /// the characters that are searched.
  std::uint64_t recognise(const writing::WrittenCharacter& ink, int limit,
                          writing::Among among = writing::Among::all);
  /// Asks whether the ink is another character than the one asked for; `named` follows. Only a character that
  /// the ink is accepted as, whatever the order of its strokes, is named.
  /// @return the number that comes back with the answer.
  std::uint64_t name_other(const writing::WrittenCharacter& ink, char32_t asked);
  /// Loads the recogniser's data now, so that the first answer is as fast as the others.
  void prepare_recogniser();

  /// The pen motion of a finished writing; emitted just before `judged` with the same number.
  base::Signal<std::uint64_t, const PenReport&> pen_reported;
  base::Signal<std::uint64_t, const writing::Grade&> judged;
  base::Signal<std::uint64_t, const std::vector<FoundCharacter>&> recognised;
  /// The other character that was written; 0: none. Ink that cannot be read is none, too.
  base::Signal<std::uint64_t, char32_t> named;
  /// Nothing was judged.
  base::Signal<std::uint64_t, const base::Error&> judging_failed;
  /// Nothing was recognised.
  base::Signal<std::uint64_t, const base::Error&> recognising_failed;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
