// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/study/learner_store.h"

namespace nazori::study {

/// Receives a text piece by piece, so that the log of many years is never in memory as a whole. An error that
/// it returns ends the operation.
using TextSink = std::function<base::Result<void>(std::string_view piece)>;

/// The source of a text, piece by piece.
struct TextSource {
  /// Reads the next bytes into the beginning of `room` and returns how many; 0 at the end.
  std::function<base::Result<std::size_t>(std::span<char> room)> read;
  std::uintmax_t bytes = 0;  ///< of the whole text, for the progress; 0 where it is not known
};
/// A text in memory, which must outlive the source.
[[nodiscard]] TextSource text_source(std::string_view text);
/// A file, from its beginning. @return Errc::not_found, Errc::io as base::InputFile::open().
[[nodiscard]] base::Result<TextSource> file_source(const std::filesystem::path& path);

/// Exports all data of a learner as JSON (docs/file-formats.md): the whole log with its ink, lists and tags.
/// After an import, an export gives the same bytes. Memory does not grow with the log.
/// @return the errors of LearnerStore::for_each_entry() and of `sink`; Errc::cancelled.
[[nodiscard]] base::Result<void> export_json(const LearnerStore& learner, const TextSink& sink,
                                             const base::Progress& progress = {});
/// The same as one text, for learners with little data.
[[nodiscard]] base::Result<std::string> export_json(const LearnerStore& learner);

/// Reads such a text completely and checks whether it can fill an empty learner. Memory does not grow with
/// the text.
/// @return Errc::parse with line and reason; Errc::schema for another format or a newer version; the errors
/// of the source; Errc::cancelled.
[[nodiscard]] base::Result<void> check_json(const TextSource& json, const base::Progress& progress = {});

/// Fills an empty learner from such a text, as one action: completely or not at all.
/// @return as check_json(); Errc::bad_argument where the learner is not empty. On an error nothing is
/// changed.
[[nodiscard]] base::Result<void> import_json(LearnerStore& learner, const TextSource& json,
                                             const base::Progress& progress = {});

/// Every writing as a table: RFC 4180, UTF-8, a header line. Those that were undone are marked.
/// @return as export_json().
[[nodiscard]] base::Result<void> export_csv(const LearnerStore& learner, const TextSink& sink,
                                            const base::Progress& progress = {});
/// The same as one text, for learners with little data.
[[nodiscard]] base::Result<std::string> export_csv(const LearnerStore& learner);

/// The content of a card for Anki.
struct AnkiOptions {
  std::string deck = "Nazori";  ///< name; "::" separates a deck from a deck inside it
  int words = 4;                ///< maximum number of words per character, 0..20
};

/// An Anki package (.apkg) of new cards that ask for a character by meaning and reading and answer with its
/// stroke order as a picture, its readings, meanings and words. The same characters always give notes with
/// the same ids, so that a second import updates the first.
/// @param characters  those without strokes are left out.
/// @source the layout "schema 11" of Anki's collections, which every Anki since 2.0 imports: AnkiDroid wiki,
/// "Database Structure".
/// @return Errc::not_found where no character has strokes, Errc::bad_argument, Errc::cancelled.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> anki_package(const kanji::KanjiDatabase& database,
                                                                   std::span<const char32_t> characters,
                                                                   const AnkiOptions& options, Time now,
                                                                   const base::Progress& progress = {});

/// A picture of a character's stroke order, as SVG: a square for each stroke, with the previous strokes in
/// grey and the new one in black, with its number and a dot where it begins.
[[nodiscard]] std::string stroke_order_svg(const kanji::Character& character);

}  // namespace nazori::study
