// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/worksheet_maker.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "nazori/base/file.h"
#include "nazori/base/latest.h"
#include "nazori/print/worksheet.h"

namespace nazori::practice {
namespace {

namespace fs = std::filesystem;

/// What the other thread keeps: the database, and the document that was laid out last.
class Bench {
 public:
  explicit Bench(CharacterSource source) : book_(std::move(source)) {}

  /// The document of a request; the one before where nothing has changed. Valid until the next call.
  base::Result<print::Worksheet*> sheet(const WorksheetRequest& request, const base::Progress& progress) {
    const auto anew = book_.look();
    if (!anew) return tl::unexpected(anew.error());
    if (sheet_ && !*anew && request == request_) return &*sheet_;
    sheet_.reset();
    count_ = 0;
    const kanji::KanjiDatabase& database = *book_.database();
    const WorksheetChoice& choice = request.choice;
    print::SheetSettings settings = choice.sheet;
    settings.text = choice.text;
    SheetCharacters characters;
    if (settings.layout != print::Layout::manuscript) {
      const auto code_points =
          choice.source == WorksheetSource::text
              ? characters_of_text(choice.text, [&database](char32_t c) { return database.draws(c); })
              : request.characters;
      std::vector<kanji::CharacterName> names;
      names.reserve(code_points.size());
      for (const char32_t c : code_points) names.push_back({c, {}});
      characters = sheet_characters(database, names, settings, book_.source().own);
      if (database.trouble()) return tl::unexpected(*database.trouble());
    }
    missing_.clear();
    for (const kanji::CharacterName& name : characters.missing) missing_.push_back(name.code_point);
    count_ = characters.found.size();
    auto made = print::Worksheet::lay_out(std::move(characters.found), std::move(settings), progress);
    if (!made) return tl::unexpected(std::move(made.error()));
    request_ = request;
    sheet_.emplace(*std::move(made));
    return &*sheet_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::vector<char32_t>& missing() const { return missing_; }

 private:
  CharacterBook book_;
  WorksheetRequest request_;
  std::optional<print::Worksheet> sheet_;
  std::size_t count_ = 0;
  std::vector<char32_t> missing_;
};

struct ShowRequest {
  WorksheetRequest request;
  std::size_t page;
};

struct SaveRequest {
  WorksheetRequest request;
  fs::path path;
};

struct Saved {
  fs::path path;
  base::Result<std::size_t> pages;
};

/// A page, or why there is none and of how many characters.
struct Answer {
  base::Result<WorksheetView> view;
  std::size_t characters = 0;
};

base::Result<WorksheetView> view_of(Bench& bench, const ShowRequest& asked, const base::Progress& progress) {
  auto sheet = bench.sheet(asked.request, progress);
  if (!sheet) return tl::unexpected(std::move(sheet.error()));
  WorksheetView view;
  view.pages = (*sheet)->page_count();
  view.page = std::min(asked.page, view.pages - 1);
  view.characters = bench.count();
  view.missing = bench.missing();
  view.drawing = std::make_shared<const print::PageDrawing>((*sheet)->page(view.page));
  return view;
}

base::Result<std::size_t> write(Bench& bench, const SaveRequest& asked, const base::Progress& progress) {
  auto sheet = bench.sheet(asked.request, base::part_of(progress, 0, 0.5));
  if (!sheet) return tl::unexpected(std::move(sheet.error()));
  const auto pdf = (*sheet)->pdf(base::part_of(progress, 0.5, 1));
  if (!pdf) return tl::unexpected(pdf.error());
  if (!progress(1, "write")) return base::fail(base::Errc::cancelled, "stopped");
  if (auto written = base::write_file(asked.path, *pdf); !written)
    return tl::unexpected(std::move(written.error()));
  return (*sheet)->page_count();
}

}  // namespace

struct WorksheetMaker::Inside {
  Inside(WorksheetMaker& maker, base::Inbox& inbox, const CharacterSource& source)
      : background(std::make_shared<base::Background>("worksheets", inbox)),
        bench(std::make_shared<Bench>(source)),
        views(
            background,
            [bench = bench](const ShowRequest& asked, const auto& run) {
              auto view =
                  view_of(*bench, asked, [&run](double, std::string_view) { return run.is_wanted(); });
              return Answer{std::move(view), bench->count()};
            },
            [&maker](const Answer& answer) {
              if (answer.view)
                maker.shown(*answer.view);
              else
                maker.refused(answer.view.error(), answer.characters);
            }),
        files(
            background,
            [bench = bench](const SaveRequest& asked, const auto& run) {
              int last = -1;
              const auto progress = [&run, &last](double done, std::string_view) {
                const int percent = static_cast<int>(done * 100);
                if (percent > last) run.report(last = percent);
                return run.is_wanted();
              };
              return Saved{asked.path, write(*bench, asked, progress)};
            },
            [&maker](const Saved& answer) {
              if (answer.pages)
                maker.saved(answer.path, *answer.pages);
              else
                maker.not_saved(answer.path, answer.pages.error());
            },
            [&maker](int percent) { maker.progressed(percent); }) {}

  std::shared_ptr<base::Background> background;
  std::shared_ptr<Bench> bench;  ///< used by the other thread alone
  base::Latest<ShowRequest, Answer> views;
  base::Latest<SaveRequest, Saved, int> files;
};

WorksheetMaker::WorksheetMaker(base::Inbox& inbox, const CharacterSource& source)
    : inside_(std::make_unique<Inside>(*this, inbox, source)) {}

WorksheetMaker::~WorksheetMaker() = default;

void WorksheetMaker::show(WorksheetRequest request, std::size_t page) {
  inside_->views.request({std::move(request), page});
}

void WorksheetMaker::save(WorksheetRequest request, const fs::path& path) {
  inside_->files.request({std::move(request), path});
}

void WorksheetMaker::stop() { inside_->files.cancel(); }

bool WorksheetMaker::is_saving() const { return inside_->files.is_busy(); }

}  // namespace nazori::practice
