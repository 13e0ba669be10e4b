// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/trajectory_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

namespace nazori::recording {
namespace {

using base::Errc;

constexpr std::size_t kBuffer = std::size_t{1} << 20;
constexpr std::array<std::string_view, 4> kColumns{"t", "x", "y", "z"};
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kHeaderRemedy = "begin with a line that names the columns, such as t,x,y,z";

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The field at the start of `row`, without its quotes; `row` then begins after the comma. A field in quotes
/// may contain commas.
std::string_view next_field(std::string_view& row, bool& more) {
  std::size_t from = 0;
  const std::string_view start = trimmed(row);
  if (!start.empty() && start.front() == '"') {
    const std::size_t open = row.find('"');
    const std::size_t close = row.find('"', open + 1);
    if (close != std::string_view::npos) from = close + 1;
  }
  const std::size_t comma = row.find(',', from);
  more = comma != std::string_view::npos;
  std::string_view field = trimmed(row.substr(0, comma));
  row.remove_prefix(more ? comma + 1 : row.size());
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

/// Text for a message: shortened, and only printable ASCII.
std::string quoted(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E) c = '?';
  return fmt::format("'{}{}'", shown, text.size() > 40 ? "..." : "");
}

}  // namespace

TrajectoryReader::TrajectoryReader(std::unique_ptr<ByteSource> source)
    : source_(std::move(source)), buffer_(kBuffer) {}

base::Result<TrajectoryReader> TrajectoryReader::open(const std::filesystem::path& path) {
  auto source = open_source(path);
  if (!source) return tl::unexpected(std::move(source.error()));
  return from(std::move(*source));
}

base::Result<TrajectoryReader> TrajectoryReader::from(std::unique_ptr<ByteSource> source) {
  TrajectoryReader reader(std::move(source));
  if (auto header = reader.read_header(); !header) return tl::unexpected(std::move(header.error()));
  return reader;
}

tl::unexpected<base::Error> TrajectoryReader::wrong(std::string what, std::string remedy) const {
  return base::fail(Errc::parse, std::move(what), fmt::format("{}:{}", source_->name(), line_),
                    std::move(remedy));
}

double TrajectoryReader::progress() const {
  const std::uint64_t size = source_->size();
  if (size == 0) return 0;
  return std::min(1.0, static_cast<double>(bytes_ - (end_ - begin_)) / static_cast<double>(size));
}

/// False at the end. The line stays in the buffer until the next call.
base::Result<bool> TrajectoryReader::next_line(std::string_view& line) {
  for (;;) {
    const char* at = buffer_.data() + begin_;
    const std::size_t have = end_ - begin_;
    const void* found = have > 0 ? std::memchr(at, '\n', have) : nullptr;
    const std::size_t length =
        found != nullptr ? static_cast<std::size_t>(static_cast<const char*>(found) - at) : have;
    if (length > kLongestLine) {
      ++line_;
      return wrong(fmt::format("the line is longer than {} bytes", kLongestLine), "is this a CSV file?");
    }
    if (found != nullptr || exhausted_) {
      if (found == nullptr && have == 0) return false;
      ++line_;
      begin_ += length + (found != nullptr ? 1 : 0);
      line = {at, length};
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      return true;
    }
    std::memmove(buffer_.data(), at, have);
    begin_ = 0;
    end_ = have;
    const auto got = source_->read(std::span(buffer_).subspan(have));
    if (!got) return tl::unexpected(got.error());
    exhausted_ = *got == 0;
    end_ += *got;
    bytes_ += *got;
  }
}

base::Result<void> TrajectoryReader::read_header() {
  std::string_view line;
  do {
    const auto got = next_line(line);
    if (!got) return tl::unexpected(got.error());
    if (!*got) {
      line_ = std::max<std::uint64_t>(line_, 1);
      return wrong("the file is empty", std::string(kHeaderRemedy));
    }
    if (line_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  } while (trimmed(line).empty());

  std::array<int, kColumns.size()> seen{};
  for (bool more = true; more;) {
    const std::string_view name = next_field(line, more);
    const auto* column = std::find(kColumns.begin(), kColumns.end(), name);
    if (column == kColumns.end()) {
      meaning_.push_back(-1);
      continue;
    }
    const auto which = static_cast<std::size_t>(column - kColumns.begin());
    if (++seen[which] > 1) return wrong(fmt::format("the header names the column {} twice", name));
    meaning_.push_back(static_cast<int>(which));
  }
  std::string missing;
  for (std::size_t i = 0; i < kColumns.size(); ++i)
    if (seen[i] == 0) missing.append(missing.empty() ? "" : ", ").append(kColumns[i]);
  if (!missing.empty()) {
    return wrong(fmt::format("the header lacks the column{} {}", missing.size() > 1 ? "s" : "", missing),
                 std::string(kHeaderRemedy));
  }
  return {};
}

base::Result<void> TrajectoryReader::parse_row(std::string_view row, TrajectoryPoint& point) const {
  const std::array<double*, kColumns.size()> to{&point.time_s, &point.position_m.x, &point.position_m.y,
                                                &point.position_m.z};
  std::size_t column = 0;
  for (bool more = true; more; ++column) {
    if (column == meaning_.size())
      return wrong(fmt::format("the row has more values than the header's {}", meaning_.size()));
    const std::string_view field = next_field(row, more);
    const int meaning = meaning_[column];
    if (meaning < 0) continue;
    const auto which = static_cast<std::size_t>(meaning);
    const char* begin = field.data();
    const char* end = begin + field.size();
    if (field.size() > 1 && field[0] == '+' && field[1] != '-') ++begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) {
      const std::string name(kColumns[which]);
      if (field.empty()) return wrong(fmt::format("{} is missing", name));
      return wrong(fmt::format("{} is not a finite number: {}", name, quoted(field)),
                   "write numbers such as 0.0125 or 1.25e-2");
    }
    *to[which] = value;
  }
  if (column < meaning_.size()) {
    return wrong(fmt::format("the row has {} of the header's {} values", column, meaning_.size()));
  }
  return {};
}

base::Result<bool> TrajectoryReader::next(TrajectoryPoint& point) {
  std::string_view line;
  do {
    const auto got = next_line(line);
    if (!got) return tl::unexpected(got.error());
    if (!*got) {
      if (rows_ == 0) return wrong("the header is all there is", "give at least one row");
      return false;
    }
  } while (trimmed(line).empty());
  if (auto row = parse_row(line, point); !row) return tl::unexpected(std::move(row.error()));
  if (rows_ > 0 && point.time_s <= last_s_) {
    return wrong(point.time_s < last_s_ ? fmt::format("time goes back from {} to {}", last_s_, point.time_s)
                                        : fmt::format("the time {} comes twice", point.time_s),
                 "sort the rows by t, one row a moment");
  }
  ++rows_;
  last_s_ = point.time_s;
  return true;
}

}  // namespace nazori::recording
