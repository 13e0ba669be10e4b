// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/base/result.h"

namespace nazori::study {

using Json = nlohmann::ordered_json;

inline constexpr int kDeepest = 64;  ///< no text of ours is nested deeper

/// What the parser says is wrong, without the place where it says that.
[[nodiscard]] std::string reason_of(const nlohmann::detail::exception& error);

/// Parses a whole JSON text. @return Errc::parse with the line in Error::where ("line 3").
[[nodiscard]] base::Result<Json> parse_json(std::string_view text);

/// The line, from 1, on which the value at `pointer` ("/cases/0/steps/2/at") ends; nullopt where it is not.
/// Reads the text again: for the message of an error only.
[[nodiscard]] std::optional<int> line_of(std::string_view text, std::string_view pointer);

/// Reads members of an object and remembers the first thing that is wrong, with its place. After a failure
/// every answer is a default one.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}
  /// Reads a part of a longer text. @param pointer  to the part ("/entries/3"); @param first_line  its first.
  JsonReader(std::string_view part, std::string pointer, int first_line)
      : text_(part), part_(std::move(pointer)), first_line_(first_line) {}

  /// The members of one object of the text.
  class Object {
   public:
    Object(JsonReader& reader, const Json& value, std::string pointer);
    [[nodiscard]] bool has(const char* member) const;  ///< there, and not null
    [[nodiscard]] std::string text(const char* member, std::size_t longest = 10'000);
    [[nodiscard]] std::int64_t whole(const char* member, std::int64_t lowest, std::int64_t highest);
    [[nodiscard]] double number(const char* member, double lowest, double highest);
    [[nodiscard]] bool truth(const char* member);
    [[nodiscard]] Object object(const char* member);
    /// The text of a member in one line, whatever it is.
    [[nodiscard]] std::string raw(const char* member);
    /// Calls `take` for each element of an array of objects, until something is wrong.
    template <class Take>
    void each(const char* member, Take take) {
      const Json* list = array(member);
      if (list == nullptr) return;
      for (std::size_t i = 0; i < list->size() && reader_->ok(); ++i) {
        Object one(*reader_, (*list)[i], pointer_ + "/" + member + "/" + std::to_string(i));
        take(one);
      }
    }
    /// The array `member`; nullptr after a failure.
    [[nodiscard]] const Json* array(const char* member);
    [[nodiscard]] std::string pointer_to(const char* member) const { return pointer_ + "/" + member; }
    /// Says what is wrong with a member.
    void refuse(const char* member, std::string what, std::string remedy = {});

   private:
    [[nodiscard]] const Json* find(const char* member);
    JsonReader* reader_;
    const Json* value_;
    std::string pointer_;
  };

  [[nodiscard]] Object root(const Json& value) { return {*this, value, ""}; }
  [[nodiscard]] bool ok() const { return !error_; }
  /// The first failure; call it only where ok() is false.
  [[nodiscard]] const base::Error& error() const { return *error_; }
  void refuse(const std::string& pointer, std::string what, std::string remedy);

 private:
  std::string_view text_;
  std::string part_;
  int first_line_ = 1;
  std::optional<base::Error> error_;
};

}  // namespace nazori::study
