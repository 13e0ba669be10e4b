// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_judge.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "nazori/base/latest.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model_library.h"

namespace nazori::practice {
namespace {

/// The grader's database and models.
struct Books {
  explicit Books(CharacterSource from) : book(std::move(from)) {}

  CharacterBook book;
  std::optional<writing::ModelLibrary> models;

  struct Answer {
    writing::Grade grade;
    PenReport pen;
    bool finished = true;
  };

  base::Result<Answer> grade(const JudgeRequest& request) {
    const auto anew = book.look();
    if (!anew) return tl::unexpected(anew.error());
    if (*anew) models.emplace(*book.database());
    const auto entry = models->find(request.character);
    if (!entry) return tl::unexpected(entry.error());
    writing::GradeOptions options;
    options.strictness = request.strictness;
    options.unfinished = !request.finished;
    const auto grade = request.finished
                           ? writing::grade(request.ink, (*entry)->model, options, (*entry)->lookalikes)
                           : writing::grade_live(request.ink, (*entry)->model, options, (*entry)->lookalikes);
    if (!grade) return tl::unexpected(grade.error());
    Answer answer{*grade, {}, request.finished};
    if (request.finished) {
      answer.pen.motions = writing::pen_motion(request.ink);
      answer.pen.remarks = writing::motion_remarks(answer.pen.motions, *grade, (*entry)->model);
    }
    return answer;
  }
};

/// Candidates that are looked at to name another character.
constexpr int kMostNamed = 8;

/// Whether two characters of different scripts look the same, so that one cannot be told from the other.
bool looks_same(char32_t a, char32_t b) {
  constexpr std::u32string_view kPairs = U"へヘべベぺペ口ロ力カ二ニ一ー夕タ工エ卜ト八ハ千チ";
  for (std::size_t i = 0; i + 1 < kPairs.size(); i += 2)
    if ((kPairs[i] == a && kPairs[i + 1] == b) || (kPairs[i] == b && kPairs[i + 1] == a)) return true;
  return false;
}

/// The recogniser, once its data are loaded.
struct Reader {
  explicit Reader(CharacterSource from) : book(std::move(from)) {}

  CharacterBook book;
  std::optional<writing::Recogniser> recogniser;
  std::optional<writing::ModelLibrary> models;
  std::unordered_map<char32_t, kanji::Summary> summaries;

  base::Result<void> learn() {
    const auto anew = book.look();
    if (!anew) return tl::unexpected(anew.error());
    if (!*anew && recogniser) return {};
    const kanji::KanjiDatabase& database = *book.database();
    auto made = writing::Recogniser::make(database);
    if (!made) return tl::unexpected(made.error());
    summaries.clear();
    for (auto& summary : database.list(kanji::List::all)) summaries.emplace(summary.code_point, summary);
    recogniser.emplace(std::move(*made));
    models.emplace(database);
    return {};
  }

  /// The other character that the ink is; 0: none.
  char32_t name(const writing::WrittenCharacter& ink, char32_t asked) {
    if (!learn()) return 0;
    const auto candidates = recogniser->recognise(ink, {.limit = kMostNamed, .unfinished = false});
    if (!candidates) return 0;
    char32_t found = 0;
    for (const auto& candidate : *candidates) {
      // What is liker the character that was asked for is a bad writing of it.
      if (candidate.character == asked) break;
      if (kanji::script_of(candidate.character) == kanji::Script::latin ||
          looks_same(candidate.character, asked))
        continue;
      const auto entry = models->find(candidate.character);
      if (!entry) continue;
      const auto grade =
          writing::grade(ink, (*entry)->model, {.strictness = writing::kOrderIsAdvice}, (*entry)->lookalikes);
      if (!grade || !grade->accepted) continue;
      // 口 rather than ロ where a kanji was asked for.
      if (kanji::script_of(candidate.character) == kanji::script_of(asked)) return candidate.character;
      if (found == 0) found = candidate.character;
    }
    return found;
  }

  base::Result<std::vector<FoundCharacter>> read(const writing::WrittenCharacter& ink, int limit,
                                                 writing::Among among) {
    if (auto learned = learn(); !learned) return tl::unexpected(learned.error());
    const auto ends_here = recogniser->recognise(ink, {.limit = limit, .unfinished = false, .among = among});
    if (!ends_here) return tl::unexpected(ends_here.error());
    const auto goes_on = recogniser->recognise(ink, {.limit = limit, .unfinished = true, .among = among});
    if (!goes_on) return tl::unexpected(goes_on.error());
    std::vector<FoundCharacter> all;
    const auto add = [&](const std::vector<writing::Candidate>& from, std::size_t i) {
      if (i >= from.size() || all.size() >= static_cast<std::size_t>(limit)) return;
      const bool known = std::any_of(all.begin(), all.end(), [&](const FoundCharacter& other) {
        return other.character == from[i].character;
      });
      if (known) return;
      const auto& summary = summaries[from[i].character];
      all.push_back({from[i].character, from[i].likeness, summary.meaning, summary.reading});
    };
    for (std::size_t i = 0; i < std::max(ends_here->size(), goes_on->size()); ++i) {
      add(*ends_here, i);
      add(*goes_on, i);
    }
    return all;
  }
};

struct InkToName {
  writing::WrittenCharacter ink;
  char32_t asked;
};

/// Another character with its request number.
struct Name {
  std::uint64_t number;
  char32_t character;
};

struct InkToRead {
  writing::WrittenCharacter ink;
  int limit;
  writing::Among among;
};

/// An answer with its request number.
template <class Found>
struct Numbered {
  std::uint64_t number;
  base::Result<Found> found;
};

using Judgement = Numbered<Books::Answer>;
using Reading = Numbered<std::vector<FoundCharacter>>;

}  // namespace

struct WritingJudge::Inside {
  Inside(WritingJudge& judge, base::Inbox& inbox, const CharacterSource& source)
      : grader(
            "grader", inbox,
            [books = std::make_shared<Books>(source)](const JudgeRequest& request, const auto& run) {
              return Judgement{run.ticket(), books->grade(request)};
            },
            [&judge](const Judgement& answer) {
              if (!answer.found) {
                judge.judging_failed(answer.number, answer.found.error());
                return;
              }
              if (answer.found->finished) judge.pen_reported(answer.number, answer.found->pen);
              judge.judged(answer.number, answer.found->grade);
            }),
        reader(std::make_shared<Reader>(source)),
        recogniser_thread(std::make_shared<base::Background>("recogniser", inbox)),
        recogniser(
            recogniser_thread,
            [reader = reader](const InkToRead& request, const auto& run) {
              return Reading{run.ticket(), reader->read(request.ink, request.limit, request.among)};
            },
            [&judge](const Reading& answer) {
              if (answer.found)
                judge.recognised(answer.number, *answer.found);
              else
                judge.recognising_failed(answer.number, answer.found.error());
            }),
        namer(
            recogniser_thread,
            [reader = reader](const InkToName& request, const auto& run) {
              return Name{run.ticket(), reader->name(request.ink, request.asked)};
            },
            [&judge](const Name& answer) { judge.named(answer.number, answer.character); }) {}

  base::Latest<JudgeRequest, Judgement> grader;
  std::shared_ptr<Reader> reader;  ///< used by its thread only
  std::shared_ptr<base::Background> recogniser_thread;
  base::Latest<InkToRead, Reading> recogniser;
  base::Latest<InkToName, Name> namer;
};

WritingJudge::WritingJudge(base::Inbox& inbox, const CharacterSource& source)
    : inside_(std::make_unique<Inside>(*this, inbox, source)) {}

WritingJudge::~WritingJudge() = default;

std::uint64_t WritingJudge::judge(const JudgeRequest& request) { return inside_->grader.request(request); }

std::uint64_t WritingJudge::recognise(const writing::WrittenCharacter& ink, int limit, writing::Among among) {
  return inside_->recogniser.request({ink, limit, among});
}

std::uint64_t WritingJudge::name_other(const writing::WrittenCharacter& ink, char32_t asked) {
  return inside_->namer.request({ink, asked});
}

void WritingJudge::prepare_recogniser() {
  // A failure is reported at the next request.
  inside_->recogniser_thread->post([reader = inside_->reader] { (void)reader->learn(); });
}

}  // namespace nazori::practice
