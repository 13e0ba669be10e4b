// SPDX-License-Identifier: Apache-2.0
#include "database_currency.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSource = std::size_t{256} << 20;

base::Result<std::string> sha256_of(const fs::path& path) {
  const auto bytes = base::read_file(path, kLargestSource);
  if (!bytes) return tl::unexpected(bytes.error());
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned int length = 0;
  if (EVP_Digest(bytes->data(), bytes->size(), sum.data(), &length, EVP_sha256(), nullptr) != 1) {
    return base::fail(base::Errc::io, "its checksum cannot be computed", path.string());
  }
  std::string text;
  for (unsigned int i = 0; i < length; ++i) text += fmt::format("{:02x}", sum[i]);
  return text;
}

}  // namespace

base::Result<bool> is_current(const ingest::Sources& sources, const fs::path& path) {
  const auto database = kanji::KanjiDatabase::open(path);
  if (!database) return false;
  const std::vector<kanji::Source> built_from = database->sources();
  for (const fs::path& source : {sources.kanjivg_tgz, sources.kanjidic2_xml_gz, sources.edict}) {
    const auto sum = sha256_of(source);
    if (!sum) return tl::unexpected(sum.error());
    if (std::none_of(built_from.begin(), built_from.end(),
                     [&sum](const kanji::Source& known) { return known.sha256 == *sum; })) {
      return false;
    }
  }
  return true;
}

}  // namespace nazori::cli
