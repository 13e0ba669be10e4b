// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/kanji_database.h"
#include "worker.h"

namespace nazori::ui {

/// A component of a character and where a click on it leads.
struct Part {
  std::string element;  ///< as drawn in the character, "亻"
  char32_t target =
      0;  ///< the character to go to: itself, or what it stands for (人); 0 where neither can be shown
  std::string original;  ///< what it is a form of, "人"; empty where it is itself
  std::string meaning;   ///< first English meaning of the target
};

/// All that the information panel shows of one character, gathered in one go.
struct CharacterSheet {
  kanji::Character character;
  std::optional<kanji::Radical> radical;
  std::vector<Part> parts;
  std::vector<kanji::Word> words;
};

using Summaries = std::shared_ptr<const std::vector<kanji::Summary>>;

/// The kanji database behind a thread of its own. Requests return at once; answers come as signals on the
/// thread of this object. Of several requests of one kind only the newest is answered.
class Library final : public QObject {
  Q_OBJECT
 public:
  static constexpr int kMaxWords = 60;

  explicit Library(std::filesystem::path path, QObject* parent = nullptr);
  ~Library() override;

  void request_list(kanji::List which);
  void request_search(const QString& text);
  void request_sheet(char32_t code_point);

 signals:
  void opened(std::vector<nazori::kanji::Source> sources);
  void failed(nazori::base::Error error);  ///< it cannot be opened, or not all of it can be read
  void listed(nazori::kanji::List which, nazori::ui::Summaries characters);
  void found(QString text, nazori::ui::Summaries characters);
  void sheet_ready(std::shared_ptr<const nazori::ui::CharacterSheet> sheet);
  void sheet_missing(char32_t code_point);

 private:
  /// On the worker: says once that the database is damaged, so that nothing found is not taken for the
  /// answer.
  void tell_trouble(const kanji::KanjiDatabase& database);
  bool told_trouble_ = false;                                      // touched by the worker only
  std::shared_ptr<std::optional<kanji::KanjiDatabase>> database_;  // touched by the worker only
  std::atomic<std::uint64_t> newest_list_{0};
  std::atomic<std::uint64_t> newest_search_{0};
  std::atomic<std::uint64_t> newest_sheet_{0};
  Worker worker_{QStringLiteral("library")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
