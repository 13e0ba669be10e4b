// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <string>
#include <vector>

#include "nazori/json/json.h"

namespace nazori::json {
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
class PlaceFinder : public nlohmann::json_sax<Value> {
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
    return true;
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

}  // namespace

std::optional<int> line_of(std::string_view text, std::string_view pointer) {
  CountingIterator::Count count;
  PlaceFinder finder(pointer, count);
  (void)Value::sax_parse(CountingIterator(text.data(), &count),
                         CountingIterator(text.data() + text.size(), &count), &finder);
  return finder.line();
}

}  // namespace nazori::json
