// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/json/json.h"

namespace nazori::json {

/// Reads members of objects and remembers the first thing that is wrong, with its place. After a failure
/// every answer is a default one, so a whole document is read without a test after each member.
class Reader {
 public:
  /// @param text  that was parsed; outlives the reader. Errors name lines of it.
  explicit Reader(std::string_view text) : text_(text) {}
  /// Reads a part of a longer text. @param pointer  to the part ("/entries/3"). @param first_line  of the
  /// part, from 1.
  Reader(std::string_view part, std::string pointer, int first_line)
      : text_(part), part_(std::move(pointer)), first_line_(first_line) {}

  /// The members of one object of the text. A member that is missing or of another kind is a failure, unless
  /// said otherwise.
  class Object {
   public:
    /// @param value  outlives this; a failure where it is no object. @param pointer  to it ("/plate").
    Object(Reader& reader, const Value& value, std::string pointer);

    /// Whether the member is there, be it null.
    [[nodiscard]] bool is_there(const char* member) const;
    /// Whether the member is there and not null.
    [[nodiscard]] bool has(const char* member) const;
    /// A text of at most `longest` bytes.
    [[nodiscard]] std::string text(const char* member, std::size_t longest = 10'000);
    /// A whole number from `lowest` to `highest`, written without a point.
    [[nodiscard]] std::int64_t whole(const char* member, std::int64_t lowest, std::int64_t highest);
    /// A number from `lowest` to `highest`.
    [[nodiscard]] double number(const char* member, double lowest, double highest);
    /// True or false.
    [[nodiscard]] bool truth(const char* member);
    /// An object within this one.
    [[nodiscard]] Object object(const char* member);
    /// An array of exactly `count` numbers.
    [[nodiscard]] std::vector<double> numbers(const char* member, std::size_t count);
    /// The text of a member in one line, whatever it is.
    [[nodiscard]] std::string raw(const char* member);
    /// Calls `take(Object&)` for each element of an array of objects, until something is wrong.
    template <class Take>
    void each(const char* member, Take take) {
      const Value* list = array(member);
      if (list == nullptr) return;
      for (std::size_t i = 0; i < list->size() && reader_->ok(); ++i) {
        Object one(*reader_, (*list)[i], pointer_ + "/" + member + "/" + std::to_string(i));
        take(one);
      }
    }
    /// The array `member`; nullptr after a failure.
    [[nodiscard]] const Value* array(const char* member);

    /// Reads a member that may be left out: `to` stays as it is where the member is missing. Null is a value
    /// of another kind, and so a failure.
    void read(const char* member, std::string& to);
    void read(const char* member, bool& to);
    void read(const char* member, int& to, int lowest, int highest);
    void read(const char* member, double& to, double lowest, double highest);

    /// The path of a member, for those who look at a value themselves.
    [[nodiscard]] std::string pointer_to(const char* member) const { return pointer_ + "/" + member; }
    /// Says what is wrong with a member, and what would be right.
    void refuse(const char* member, std::string what, std::string remedy = {});

   private:
    [[nodiscard]] const Value* find(const char* member);
    Reader* reader_;
    const Value* value_;
    std::string pointer_;
  };

  /// The outermost value of the text. @param value  outlives the answer.
  [[nodiscard]] Object root(const Value& value) { return {*this, value, ""}; }
  /// Whether nothing is wrong so far.
  [[nodiscard]] bool ok() const { return !error_; }
  /// The first failure: Errc::parse, with the place in Error::where ("line 3, cases/0/at"). Call it only
  /// where ok() is false.
  [[nodiscard]] const base::Error& error() const { return *error_; }
  /// Says what is wrong with the value at `pointer`; only the first failure is kept.
  void refuse(const std::string& pointer, std::string what, std::string remedy);

 private:
  std::string_view text_;
  std::string part_;
  int first_line_ = 1;
  std::optional<base::Error> error_;
};

}  // namespace nazori::json
