// SPDX-License-Identifier: Apache-2.0
#include "source_files.h"

#include <archive.h>
#include <archive_entry.h>
#include <iconv.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <memory>
#include <utility>
#include <vector>

#include "nazori/base/file.h"

namespace nazori::ingest {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 128UL * 1024;
constexpr std::size_t kLargestSource = 256UL * 1024 * 1024;

tl::unexpected<base::Error> damaged(const fs::path& path, const std::string& how) {
  return base::fail(base::Errc::parse, "is damaged: " + how, path.string());
}

/// Opens a regular file, or returns the error.
base::Result<std::ifstream> open_source(const fs::path& path) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return base::fail(base::Errc::not_found, "does not exist", path.string());
  if (!fs::is_regular_file(status)) return base::fail(base::Errc::io, "is not a regular file", path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file) return base::fail(base::Errc::io, "cannot be read", path.string());
  return file;
}

/// Unpacks a gzip file piece by piece and checks it at its end.
class GzipReader {
 public:
  static base::Result<std::unique_ptr<GzipReader>> open(const fs::path& path) {
    auto file = open_source(path);
    if (!file) return tl::unexpected(file.error());
    auto reader = std::unique_ptr<GzipReader>(new GzipReader(std::move(*file)));
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&reader->stream_, kGzipOnly) != Z_OK) {
      return base::fail(base::Errc::io, "cannot be unpacked: no memory", path.string());
    }
    reader->ready_ = true;
    return reader;
  }
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;
  ~GzipReader() {
    if (ready_) inflateEnd(&stream_);
  }

  /// The next piece, at most `size` bytes; 0 at the end or after an error.
  std::size_t read(char* to, std::size_t size) {
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(size);
    while (stream_.avail_out > 0 && !done_ && fault_.empty()) {
      if (stream_.avail_in == 0 && !fill()) break;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      if (status == Z_STREAM_END) {
        done_ = true;
      } else if (status != Z_OK && status != Z_BUF_ERROR) {
        fault_ = stream_.msg == nullptr ? "not a gzip file" : stream_.msg;
      }
    }
    return size - stream_.avail_out;
  }
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  explicit GzipReader(std::ifstream file) : file_(std::move(file)), input_(kChunk) {}

  bool fill() {
    file_.read(input_.data(), static_cast<std::streamsize>(input_.size()));
    stream_.next_in = reinterpret_cast<Bytef*>(input_.data());
    stream_.avail_in = static_cast<uInt>(file_.gcount());
    if (stream_.avail_in == 0) fault_ = "it is cut off";
    return stream_.avail_in > 0;
  }

  std::ifstream file_;
  std::vector<char> input_;
  z_stream stream_{};
  std::string fault_;
  bool ready_ = false;
  bool done_ = false;
};

/// The input from which libarchive reads the tar.
struct TarInput {
  GzipReader& gzip;
  std::vector<char> chunk = std::vector<char>(kChunk);
};

la_ssize_t read_tar_bytes(archive* /*tar*/, void* data, const void** buffer) {
  auto& input = *static_cast<TarInput*>(data);
  *buffer = input.chunk.data();
  return static_cast<la_ssize_t>(input.gzip.read(input.chunk.data(), input.chunk.size()));
}

struct FreeArchive {
  void operator()(archive* tar) const { archive_read_free(tar); }
};
struct CloseConverter {
  void operator()(void* converter) const { iconv_close(converter); }
};
struct FreeDigest {
  void operator()(EVP_MD_CTX* digest) const { EVP_MD_CTX_free(digest); }
};

std::string text_of(const char* text) { return text == nullptr ? "unknown fault" : text; }

base::Result<std::string> member_content(archive* tar, archive_entry* entry, const fs::path& path,
                                         std::size_t max_bytes) {
  const auto size = archive_entry_size(entry);
  const std::string name = text_of(archive_entry_pathname(entry));
  if (size < 0 || static_cast<std::uint64_t>(size) > max_bytes) {
    return base::fail(base::Errc::parse, "is too large", path.string() + ":" + name);
  }
  std::string content(static_cast<std::size_t>(size), '\0');
  std::size_t have = 0;
  while (have < content.size()) {
    const auto n = archive_read_data(tar, content.data() + have, content.size() - have);
    if (n < 0) return damaged(path, text_of(archive_error_string(tar)));
    if (n == 0) return damaged(path, name + " is cut off");
    have += static_cast<std::size_t>(n);
  }
  return content;
}

}  // namespace

base::Result<std::string> sha256_of(const fs::path& path) {
  auto file = open_source(path);
  if (!file) return tl::unexpected(file.error());
  const std::unique_ptr<EVP_MD_CTX, FreeDigest> digest(EVP_MD_CTX_new());
  bool good = digest && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1;
  std::vector<char> chunk(kChunk);
  while (good && *file) {
    file->read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    good = EVP_DigestUpdate(digest.get(), chunk.data(), static_cast<std::size_t>(file->gcount())) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned int length = 0;
  good = good && EVP_DigestFinal_ex(digest.get(), sum.data(), &length) == 1;
  if (!good || file->bad())
    return base::fail(base::Errc::io, "its checksum cannot be computed", path.string());
  std::string out;
  constexpr std::string_view kFigures = "0123456789abcdef";
  for (unsigned int i = 0; i < length; ++i) {
    out += kFigures[sum[i] >> 4U];
    out += kFigures[sum[i] & 15U];
  }
  return out;
}

base::Result<std::string> read_gzip(const fs::path& path, std::size_t max_bytes) {
  auto gzip = GzipReader::open(path);
  if (!gzip) return tl::unexpected(gzip.error());
  std::string out;
  std::vector<char> chunk(kChunk);
  while (const std::size_t n = (*gzip)->read(chunk.data(), chunk.size())) {
    if (out.size() + n > max_bytes) return damaged(path, "it unpacks to too much");
    out.append(chunk.data(), n);
  }
  if (!(*gzip)->fault().empty()) return damaged(path, (*gzip)->fault());
  return out;
}

base::Result<std::string> read_euc_jp(const fs::path& path, std::size_t max_bytes) {
  auto bytes = base::read_file(path, std::min(max_bytes, kLargestSource));
  if (!bytes) return tl::unexpected(bytes.error());
  const iconv_t opened = iconv_open("UTF-8", "EUC-JP");
  if (reinterpret_cast<std::intptr_t>(opened) == -1) {
    return base::fail(base::Errc::io, "this system cannot convert EUC-JP", path.string());
  }
  const std::unique_ptr<void, CloseConverter> converter(opened);
  std::string out;
  out.reserve(bytes->size() + bytes->size() / 4);
  std::vector<char> chunk(kChunk);
  char* in = reinterpret_cast<char*>(bytes->data());
  std::size_t left = bytes->size();
  while (left > 0) {
    char* to = chunk.data();
    std::size_t room = chunk.size();
    const std::size_t status = iconv(converter.get(), &in, &left, &to, &room);
    const int reason = errno;
    out.append(chunk.data(), chunk.size() - room);
    if (status == static_cast<std::size_t>(-1) && reason != E2BIG) {
      const auto line = std::count(out.begin(), out.end(), '\n') + 1;
      return base::fail(base::Errc::parse, "is damaged: not EUC-JP text",
                        path.string() + ":" + std::to_string(line));
    }
  }
  return out;
}

base::Result<void> read_tgz(const fs::path& path, std::size_t max_bytes,
                            const std::function<bool(std::string_view path)>& wanted,
                            const TakeMember& take) {
  auto gzip = GzipReader::open(path);
  if (!gzip) return tl::unexpected(gzip.error());
  TarInput input{**gzip};
  const std::unique_ptr<archive, FreeArchive> tar(archive_read_new());
  archive_read_support_format_tar(tar.get());
  const auto fault = [&] {
    return (*gzip)->fault().empty() ? text_of(archive_error_string(tar.get())) : (*gzip)->fault();
  };
  if (archive_read_open(tar.get(), &input, nullptr, read_tar_bytes, nullptr) != ARCHIVE_OK) {
    return damaged(path, fault());
  }
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(tar.get(), &entry)) == ARCHIVE_OK) {
    const char* const name = archive_entry_pathname(entry);
    if (name == nullptr || archive_entry_filetype(entry) != AE_IFREG || !wanted(name)) continue;
    const std::string member = name;
    auto content = member_content(tar.get(), entry, path, max_bytes);
    if (!content && !(*gzip)->fault().empty()) return damaged(path, (*gzip)->fault());
    if (!content) return tl::unexpected(content.error());
    if (auto result = take(member, std::move(*content)); !result) return result;
  }
  if (status != ARCHIVE_EOF) return damaged(path, fault());
  // libarchive stops at the end mark of the tar; the checksum of the gzip comes after it.
  while ((*gzip)->read(input.chunk.data(), input.chunk.size()) > 0) continue;
  if (!(*gzip)->fault().empty()) return damaged(path, (*gzip)->fault());
  return {};
}

}  // namespace nazori::ingest
