// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/unfinished_file.h"

#include <chrono>
#include <map>
#include <string>
#include <system_error>
#include <utility>

namespace nazori::base {
namespace {

namespace fs = std::filesystem;

struct Entry {
  fs::path path;
  UnfinishedKind kind;
};

struct Register {
  std::timed_mutex mutex;
  std::map<std::uint64_t, Entry> entries;
  std::uint64_t last_id = 0;
};

/// Never destroyed: a thread may end the program while the objects of main() are being destroyed.
Register& all() {
  static auto& kept = *new Register;
  return kept;
}

/// Never destroyed, as the register.
std::timed_mutex& making() {
  static auto& kept = *new std::timed_mutex;
  return kept;
}

void remove(const Entry& entry) {
  std::error_code ignored;
  fs::remove(entry.path, ignored);
  if (entry.kind != UnfinishedKind::database) return;
  for (const char* suffix : {"-journal", "-wal", "-shm"}) fs::remove(entry.path.string() + suffix, ignored);
}

}  // namespace

UnfinishedFile::UnfinishedFile(fs::path path, UnfinishedKind kind) {
  const std::lock_guard lock(all().mutex);
  id_ = ++all().last_id;
  all().entries.emplace(id_, Entry{std::move(path), kind});
}

UnfinishedFile UnfinishedFile::made_by(const std::function<fs::path()>& make) {
  UnfinishedFile file;
  const std::lock_guard lock(all().mutex);
  fs::path path = make();
  if (path.empty()) return file;
  file.id_ = ++all().last_id;
  all().entries.emplace(file.id_, Entry{std::move(path), UnfinishedKind::plain});
  return file;
}

UnfinishedFile::UnfinishedFile(UnfinishedFile&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

UnfinishedFile& UnfinishedFile::operator=(UnfinishedFile&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

UnfinishedFile::~UnfinishedFile() {
  if (id_ == 0) return;
  const std::lock_guard lock(all().mutex);
  const auto entry = all().entries.find(id_);
  remove(entry->second);
  all().entries.erase(entry);
}

void UnfinishedFile::finish() noexcept {
  if (id_ == 0) return;
  const std::lock_guard lock(all().mutex);
  all().entries.erase(std::exchange(id_, 0));
}

std::unique_lock<std::timed_mutex> making_files() { return std::unique_lock(making()); }

std::unique_lock<std::timed_mutex> remove_unfinished_files() {
  // Making a file may hang, on a network for example. The program must be able to end all the same.
  constexpr auto kPatience = std::chrono::milliseconds(50);
  constexpr auto kMaking = std::chrono::seconds(2);
  const std::unique_lock made(making(), kMaking);
  std::unique_lock lock(all().mutex, kPatience);
  if (!lock.owns_lock()) return lock;
  // In the order of destructors: the file registered last is removed first, a folder after its content.
  for (auto entry = all().entries.rbegin(); entry != all().entries.rend(); ++entry) remove(entry->second);
  return lock;
}

}  // namespace nazori::base
