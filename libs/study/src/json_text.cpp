// SPDX-License-Identifier: Apache-2.0
#include "json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "nazori/base/nesting.h"

namespace nazori::study {
namespace {

/// Walks over a text and counts its lines as it is read.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  struct Count {
    int lines = 1;
    char last = 0;
  };
  CountingIterator(const char* at, Count* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    count_->last = *at_;
    if (*at_ == '\n') ++count_->lines;
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  Count* count_;
};

/// Keeps the path to the present value, and stops where it is the one that is looked for.
class PlaceFinder : public nlohmann::json_sax<Json> {
 public:
  PlaceFinder(std::string_view wanted, CountingIterator::Count& count) : wanted_(wanted), count_(count) {}

  [[nodiscard]] std::optional<int> line() const { return line_; }

  bool null() override { return value(false); }
  bool boolean(bool /*value*/) override { return value(false); }
  bool number_integer(number_integer_t /*value*/) override { return value(true); }
  bool number_unsigned(number_unsigned_t /*value*/) override { return value(true); }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return value(true); }
  bool string(string_t& /*value*/) override { return value(false); }
  bool binary(binary_t& /*value*/) override { return value(false); }
  bool start_object(std::size_t /*elements*/) override { return open(-1); }
  bool end_object() override { return close(); }
  bool key(string_t& name) override {
    levels_.back().name = name;
    return true;
  }
  bool start_array(std::size_t /*elements*/) override { return open(0); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) override {
    return false;
  }

 private:
  struct Level {
    std::string name;
    int index;  ///< -1 in an object
  };

  [[nodiscard]] std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      path += "/" + (level.index < 0 ? level.name : std::to_string(level.index));
    }
    return path;
  }
  /// @return false to stop.
  bool found_here(bool number) {
    if (path() != wanted_) return false;
    // The lexer has read one character beyond a number.
    line_ = count_.lines - (number && count_.last == '\n' ? 1 : 0);
    return true;
  }
  bool value(bool number) {
    if (found_here(number)) return false;
    count_element();
    return true;
  }
  bool open(int index) {
    if (found_here(false)) return false;
    levels_.push_back({"", index});
    return levels_.size() <= kDeepest;
  }
  bool close() {
    levels_.pop_back();
    count_element();
    return true;
  }
  void count_element() {
    if (!levels_.empty() && levels_.back().index >= 0) ++levels_.back().index;
  }

  std::string_view wanted_;
  CountingIterator::Count& count_;
  std::vector<Level> levels_;
  std::optional<int> line_;
};

int line_at(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

}  // namespace

std::string reason_of(const nlohmann::detail::exception& error) {
  std::string what = error.what();
  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ...": keep the reason.
  if (const std::size_t colon = what.find(": "); colon != std::string::npos) what.erase(0, colon + 2);
  return what;
}

base::Result<Json> parse_json(std::string_view text) {
  if (base::is_nested_deeper(text, kDeepest))
    return base::fail(base::Errc::parse, "is nested too deeply", "the JSON text");
  try {
    return Json::parse(text.begin(), text.end());
  } catch (const Json::parse_error& error) {
    const std::string what = reason_of(error);
    const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
    return base::fail(base::Errc::parse, "is not JSON: " + what, fmt::format("line {}", line_at(text, byte)));
  } catch (const Json::out_of_range& error) {
    return base::fail(base::Errc::parse, std::string("is not JSON that can be read: ") + error.what());
  }
}

std::optional<int> line_of(std::string_view text, std::string_view pointer) {
  CountingIterator::Count count;
  PlaceFinder finder(pointer, count);
  (void)Json::sax_parse(CountingIterator(text.data(), &count),
                        CountingIterator(text.data() + text.size(), &count), &finder);
  return finder.line();
}

void JsonReader::refuse(const std::string& pointer, std::string what, std::string remedy) {
  if (error_) return;
  std::string place = pointer;
  std::optional<int> line = line_of(text_, place);
  // A member that is missing has no line of its own: name that of its object.
  while (!line && !place.empty()) {
    place.erase(place.rfind('/'));
    line = line_of(text_, place);
  }
  std::string where = fmt::format("line {}", first_line_ - 1 + line.value_or(1));
  if (const std::string whole = part_ + pointer; !whole.empty()) where += ", " + whole.substr(1);
  error_ = base::Error{base::Errc::parse, std::move(what), std::move(where), std::move(remedy)};
}

JsonReader::Object::Object(JsonReader& reader, const Json& value, std::string pointer)
    : reader_(&reader), value_(&value), pointer_(std::move(pointer)) {
  if (reader.ok() && !value.is_object()) reader.refuse(pointer_, "is no object", "give { ... }");
}

void JsonReader::Object::refuse(const char* member, std::string what, std::string remedy) {
  reader_->refuse(pointer_to(member), std::move(what), std::move(remedy));
}

bool JsonReader::Object::has(const char* member) const {
  return value_->is_object() && value_->contains(member) && !(*value_)[member].is_null();
}

const Json* JsonReader::Object::find(const char* member) {
  if (!reader_->ok()) return nullptr;
  if (!value_->is_object() || !value_->contains(member)) {
    refuse(member, "is missing");
    return nullptr;
  }
  return &(*value_)[member];
}

std::string JsonReader::Object::text(const char* member, std::size_t longest) {
  const Json* value = find(member);
  if (value == nullptr) return {};
  if (!value->is_string()) {
    refuse(member, "is no text");
    return {};
  }
  auto text = value->get<std::string>();
  if (text.size() > longest) {
    refuse(member, fmt::format("is longer than {} bytes", longest));
    return {};
  }
  return text;
}

std::int64_t JsonReader::Object::whole(const char* member, std::int64_t lowest, std::int64_t highest) {
  const Json* value = find(member);
  if (value == nullptr) return lowest;
  const bool fits = value->is_number_integer() &&
                    (!value->is_number_unsigned() || value->get<std::uint64_t>() <= INT64_MAX);
  if (!fits || value->get<std::int64_t>() < lowest || value->get<std::int64_t>() > highest) {
    refuse(member, value->dump().substr(0, 40) + " is no whole number within its range",
           fmt::format("give {} to {}", lowest, highest));
    return lowest;
  }
  return value->get<std::int64_t>();
}

double JsonReader::Object::number(const char* member, double lowest, double highest) {
  const Json* value = find(member);
  if (value == nullptr) return lowest;
  if (!value->is_number() || !(value->get<double>() >= lowest && value->get<double>() <= highest)) {
    refuse(member,
           value->dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 40) +
               " is no number within its range",
           fmt::format("give {} to {}", lowest, highest));
    return lowest;
  }
  return value->get<double>();
}

bool JsonReader::Object::truth(const char* member) {
  const Json* value = find(member);
  if (value == nullptr) return false;
  if (!value->is_boolean()) {
    refuse(member, "is neither true nor false");
    return false;
  }
  return value->get<bool>();
}

const Json* JsonReader::Object::array(const char* member) {
  const Json* value = find(member);
  if (value == nullptr) return nullptr;
  if (!value->is_array()) {
    refuse(member, "is no list", "give [ ... ]");
    return nullptr;
  }
  return value;
}

std::string JsonReader::Object::raw(const char* member) {
  const Json* value = find(member);
  return value == nullptr ? std::string() : value->dump(-1, ' ', false, Json::error_handler_t::replace);
}

JsonReader::Object JsonReader::Object::object(const char* member) {
  static const Json kEmpty = Json::object();
  const Json* value = find(member);
  return {*reader_, value == nullptr ? kEmpty : *value, pointer_to(member)};
}

}  // namespace nazori::study
