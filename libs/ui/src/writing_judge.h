// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "nazori/writing/grade.h"
#include "nazori/writing/motion_remarks.h"
#include "nazori/writing/recogniser.h"
#include "nazori/writing/written_character.h"
#include "worker.h"

namespace nazori::ui {

/// How writing is to be judged.
struct JudgeRequest {
  char32_t character = 0;  ///< that was asked for
  writing::WrittenCharacter ink;
  double strictness = writing::kNormal;
  bool finished = true;  ///< false: stroke by stroke, more may follow
};

/// How the pen moved, and what of it is worth saying.
struct PenReport {
  std::vector<writing::PenMotion> motions;
  std::vector<writing::MotionRemark> remarks;
};

/// Judging and recognising behind threads of their own: requests return at once, answers come as signals on
/// the thread of this object. Of several requests of one kind only the newest is answered. The recogniser
/// learns all characters when it is first asked.
class WritingJudge final : public QObject {
  Q_OBJECT
 public:
  explicit WritingJudge(std::filesystem::path database, QObject* parent = nullptr);
  ~WritingJudge() override;

  /// @return the number that comes back with the answer.
  std::uint64_t judge(const JudgeRequest& request);
  /// Of characters that may end here and those that may go on, the likeliest by turns.
  std::uint64_t recognise(const writing::WrittenCharacter& ink, int limit);
  /// Lets the recogniser learn now what it needs, so that the first answer comes as soon as the others.
  void prepare_recogniser();

 signals:
  /// How finished writing was written; just before judged() with the same number.
  void pen_told(std::uint64_t ticket, nazori::ui::PenReport pen);
  void judged(std::uint64_t ticket, nazori::writing::Grade grade);
  void recognised(std::uint64_t ticket, std::vector<nazori::writing::Candidate> candidates);
  /// Nothing was judged or recognised.
  void failed(std::uint64_t ticket, nazori::base::Error error);

 private:
  struct Books;   ///< the grader's database and models
  struct Reader;  ///< the recogniser
  std::shared_ptr<Books> books_;
  std::shared_ptr<Reader> reader_;
  std::atomic<std::uint64_t> newest_judgement_{0};
  std::atomic<std::uint64_t> newest_recognition_{0};
  Worker grader_{QStringLiteral("grader")};  // last: stop before what they use goes
  Worker recogniser_{QStringLiteral("recogniser")};
};

}  // namespace nazori::ui
