// SPDX-License-Identifier: Apache-2.0
#include "writing_judge.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model_library.h"

namespace nazori::ui {

struct WritingJudge::Books {
  std::filesystem::path path;
  std::optional<kanji::KanjiDatabase> database;
  std::optional<writing::ModelLibrary> models;

  struct Answer {
    writing::Grade grade;
    PenReport pen;
  };

  base::Result<Answer> grade(const JudgeRequest& request) {
    if (!models) {
      auto opened = kanji::KanjiDatabase::open(path);
      if (!opened) return tl::unexpected(opened.error());
      database.emplace(std::move(*opened));
      models.emplace(*database);
    }
    const auto entry = models->find(request.character);
    if (!entry) return tl::unexpected(entry.error());
    writing::GradeOptions options;
    options.strictness = request.strictness;
    options.unfinished = !request.finished;
    const auto grade = request.finished
                           ? writing::grade(request.ink, (*entry)->model, options, (*entry)->lookalikes)
                           : writing::grade_live(request.ink, (*entry)->model, options, (*entry)->lookalikes);
    if (!grade) return tl::unexpected(grade.error());
    Answer answer{*grade, {}};
    if (request.finished) {
      answer.pen.motions = writing::pen_motion(request.ink);
      answer.pen.remarks = writing::motion_remarks(answer.pen.motions, *grade, (*entry)->model);
    }
    return answer;
  }
};

struct WritingJudge::Reader {
  std::filesystem::path path;
  std::optional<writing::Recogniser> recogniser;

  base::Result<void> learn() {
    if (recogniser) return {};
    const auto database = kanji::KanjiDatabase::open(path);
    if (!database) return tl::unexpected(database.error());
    auto made = writing::Recogniser::make(*database);
    if (!made) return tl::unexpected(made.error());
    recogniser.emplace(std::move(*made));
    return {};
  }

  base::Result<std::vector<writing::Candidate>> read(const writing::WrittenCharacter& ink, int limit) {
    if (auto learnt = learn(); !learnt) return tl::unexpected(learnt.error());
    const auto ends_here = recogniser->recognise(ink, {.limit = limit, .unfinished = false});
    if (!ends_here) return tl::unexpected(ends_here.error());
    const auto goes_on = recogniser->recognise(ink, {.limit = limit, .unfinished = true});
    if (!goes_on) return tl::unexpected(goes_on.error());
    std::vector<writing::Candidate> all;
    const auto add = [&](const std::vector<writing::Candidate>& from, std::size_t i) {
      if (i >= from.size() || all.size() >= static_cast<std::size_t>(limit)) return;
      const bool known = std::any_of(all.begin(), all.end(), [&](const writing::Candidate& other) {
        return other.character == from[i].character;
      });
      if (!known) all.push_back(from[i]);
    };
    for (std::size_t i = 0; i < std::max(ends_here->size(), goes_on->size()); ++i) {
      add(*ends_here, i);
      add(*goes_on, i);
    }
    return all;
  }
};

WritingJudge::WritingJudge(std::filesystem::path database, QObject* parent)
    : QObject(parent), books_(std::make_shared<Books>()), reader_(std::make_shared<Reader>()) {
  books_->path = database;
  reader_->path = std::move(database);
}

WritingJudge::~WritingJudge() = default;

std::uint64_t WritingJudge::judge(const JudgeRequest& request) {
  const std::uint64_t ticket = ++newest_judgement_;
  grader_.post([this, request, ticket, books = books_] {
    if (ticket != newest_judgement_) return;
    auto answer = books->grade(request);
    grader_.answer([this, ticket, finished = request.finished, answer = std::move(answer)] {
      if (ticket != newest_judgement_) return;
      if (!answer) {
        emit failed(ticket, answer.error());
        return;
      }
      if (finished) emit pen_told(ticket, answer->pen);
      emit judged(ticket, answer->grade);
    });
  });
  return ticket;
}

std::uint64_t WritingJudge::recognise(const writing::WrittenCharacter& ink, int limit) {
  const std::uint64_t ticket = ++newest_recognition_;
  recogniser_.post([this, ink, limit, ticket, reader = reader_] {
    if (ticket != newest_recognition_) return;
    auto candidates = reader->read(ink, limit);
    recogniser_.answer([this, ticket, candidates = std::move(candidates)] {
      if (ticket != newest_recognition_) return;
      if (candidates)
        emit recognised(ticket, *candidates);
      else
        emit failed(ticket, candidates.error());
    });
  });
  return ticket;
}

void WritingJudge::prepare_recogniser() {
  // A failure is told when something is asked.
  recogniser_.post([reader = reader_] { (void)reader->learn(); });
}

}  // namespace nazori::ui
