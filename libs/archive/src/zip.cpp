// SPDX-License-Identifier: Apache-2.0
#include "nazori/archive/zip.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace nazori::archive {
namespace {

using base::Errc;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

la_ssize_t take_bytes(::archive* /*zip*/, void* to, const void* bytes, std::size_t size) {
  auto& all = *static_cast<std::vector<std::uint8_t>*>(to);
  const auto* const first = static_cast<const std::uint8_t*>(bytes);
  all.insert(all.end(), first, first + size);
  return static_cast<la_ssize_t>(size);
}

std::string reason_of(::archive* zip) {
  const char* const why = archive_error_string(zip);
  return why != nullptr ? why : "it cannot be read";
}

tl::unexpected<base::Error> damaged(std::string how, std::string where = {}) {
  return base::fail(Errc::parse, "is damaged: " + std::move(how), std::move(where));
}

base::Result<std::vector<std::uint8_t>> content_of(::archive* zip, const std::string& name,
                                                   std::size_t most) {
  std::vector<std::uint8_t> content;
  std::vector<std::uint8_t> piece(64UL * 1024);
  while (true) {
    const la_ssize_t count = archive_read_data(zip, piece.data(), piece.size());
    if (count < 0) return damaged(reason_of(zip), name);
    if (count == 0) return content;
    const auto size = static_cast<std::size_t>(count);
    if (size > most - content.size()) return base::fail(Errc::parse, "unpacks to too much", name);
    content.insert(content.end(), piece.begin(), piece.begin() + count);
  }
}

}  // namespace

ZipWriter::ZipWriter(std::optional<int> level, std::optional<std::time_t> time)
    : time_(time), zip_(archive_write_new()) {
  auto* const zip = static_cast<::archive*>(zip_);
  const std::string number = std::to_string(level.value_or(0));
  ok_ = archive_write_set_format_zip(zip) == ARCHIVE_OK &&
        (!level ||
         archive_write_set_format_option(zip, "zip", "compression-level", number.c_str()) == ARCHIVE_OK) &&
        archive_write_set_bytes_in_last_block(zip, 1) == ARCHIVE_OK &&
        archive_write_open(zip, &bytes_, nullptr, &take_bytes, nullptr) == ARCHIVE_OK;
}

ZipWriter::~ZipWriter() { archive_write_free(static_cast<::archive*>(zip_)); }

void ZipWriter::add(std::string_view name, std::span<const std::uint8_t> content) {
  auto* const zip = static_cast<::archive*>(zip_);
  const Entry entry(archive_entry_new(), &archive_entry_free);
  archive_entry_set_pathname(entry.get(), std::string(name).c_str());
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), 0644);
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
  if (time_) archive_entry_set_mtime(entry.get(), *time_, 0);
  ok_ = ok_ && archive_write_header(zip, entry.get()) == ARCHIVE_OK &&
        archive_write_data(zip, content.data(), content.size()) == static_cast<la_ssize_t>(content.size());
}

void ZipWriter::add(std::string_view name, std::string_view content) {
  add(name, std::span(reinterpret_cast<const std::uint8_t*>(content.data()), content.size()));
}

base::Result<std::vector<std::uint8_t>> ZipWriter::finish() {
  auto* const zip = static_cast<::archive*>(zip_);
  if (ok_ && archive_write_close(zip) == ARCHIVE_OK) return std::move(bytes_);
  const char* const why = archive_error_string(zip);
  return base::fail(Errc::io, why != nullptr ? why : "the archive cannot be made", "ZIP");
}

base::Result<std::vector<ZipMember>> read_zip(std::span<const std::uint8_t> bytes, const ZipLimits& limits) {
  const std::unique_ptr<::archive, decltype(&archive_read_free)> zip(archive_read_new(), &archive_read_free);
  if (archive_read_support_format_zip(zip.get()) != ARCHIVE_OK ||
      archive_read_open_memory(zip.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
    return base::fail(Errc::parse, "is not a ZIP");
  std::vector<ZipMember> members;
  std::size_t left = limits.bytes;
  std::size_t entries = 0;
  archive_entry* entry = nullptr;
  while (true) {
    const int status = archive_read_next_header(zip.get(), &entry);
    if (status == ARCHIVE_EOF) break;
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
      return entries == 0 ? base::fail(Errc::parse, "is not a ZIP") : damaged(reason_of(zip.get()));
    if (++entries > limits.members) return base::fail(Errc::parse, "has too many members");
    const char* const name = archive_entry_pathname_utf8(entry);
    // Without a UTF-8 locale, libarchive cannot give names that are not ASCII: nobody asks for such members.
    if (name == nullptr || archive_entry_filetype(entry) != AE_IFREG) continue;
    if (!limits.only.empty() && std::ranges::find(limits.only, name) == limits.only.end()) continue;
    ZipMember member{name, {}};
    const auto same = [&member](const ZipMember& other) { return other.name == member.name; };
    if (std::ranges::any_of(members, same)) return damaged("there are two members of one name", member.name);
    if (archive_entry_is_encrypted(entry) != 0) return base::fail(Errc::parse, "is encrypted", member.name);
    auto content = content_of(zip.get(), member.name, left);
    if (!content) return tl::unexpected(std::move(content).error());
    left -= content->size();
    member.content = *std::move(content);
    members.push_back(std::move(member));
  }
  if (entries == 0) return base::fail(Errc::parse, "is not a ZIP");
  return members;
}

}  // namespace nazori::archive
