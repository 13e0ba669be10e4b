// SPDX-License-Identifier: Apache-2.0
#include "nazori/json/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace nazori::json {
namespace {

using base::Errc;

/// "line 3, column 7" of a byte.
std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t last = before.rfind('\n');
  const std::size_t column = last == std::string_view::npos ? before.size() + 1 : before.size() - last;
  return fmt::format("line {}, column {}", line, column);
}

/// Builds a value from a text and stops at the first limit that is exceeded.
class Builder final : public nlohmann::json_sax<Value> {
 public:
  Builder(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {}

  bool null() override { return put(nullptr); }
  bool boolean(bool truth) override { return put(truth); }
  bool number_integer(number_integer_t number) override { return put(number); }
  bool number_unsigned(number_unsigned_t number) override { return put(number); }
  bool number_float(number_float_t number, const string_t& /*text*/) override { return put(number); }
  bool string(string_t& text) override { return put(std::move(text)); }
  bool binary(binary_t& /*value*/) override { return put(nullptr); }
  bool start_object(std::size_t /*elements*/) override { return open(Value::object()); }
  bool start_array(std::size_t /*elements*/) override { return open(Value::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    Value& object = *open_.back();
    // A member is looked for among those that are there already, so their number is the cost of the next.
    if (object.size() >= limits_.members && !object.contains(name))
      return stop(fmt::format("has an object of more than {} members", limits_.members));
    member_ = &(object[name] = nullptr);
    return true;
  }
  bool parse_error(std::size_t byte, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    error_ = base::Error{Errc::parse, "is not JSON: " + reason_of(error),
                         place_of(text_, byte > 0 ? byte - 1 : 0), ""};
    return false;
  }

  [[nodiscard]] base::Result<Value> result() && {
    if (error_) return tl::unexpected(*std::move(error_));
    return std::move(root_);
  }

 private:
  bool stop(std::string what) {
    error_ = base::Error{Errc::parse, std::move(what), "the JSON text", ""};
    return false;
  }
  /// Where the next value goes.
  Value& place() {
    if (open_.empty()) return root_;
    if (open_.back()->is_object()) return *member_;
    return open_.back()->emplace_back();
  }
  bool put(Value value) {
    place() = std::move(value);
    return true;
  }
  bool open(Value container) {
    if (open_.size() >= static_cast<std::size_t>(limits_.depth)) return stop("is nested too deeply");
    Value& here = place();
    here = std::move(container);
    open_.push_back(&here);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const Limits& limits_;
  Value root_;
  std::vector<Value*> open_;  ///< the innermost last; nothing is added to the others meanwhile
  Value* member_ = nullptr;   ///< of the innermost object
  std::optional<base::Error> error_;
};

}  // namespace

std::string reason_of(const nlohmann::detail::exception& error) {
  std::string what = error.what();
  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ...": keep the reason.
  if (const std::size_t colon = what.find(": "); colon != std::string::npos) what.erase(0, colon + 2);
  return what;
}

base::Result<Value> parse(std::string_view text, const Limits& limits) {
  if (text.size() > limits.bytes)
    return base::fail(Errc::parse, fmt::format("is longer than {} bytes", limits.bytes), "the JSON text");
  Builder builder(text, limits);
  (void)Value::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder).result();
}

std::string to_line(const Value& value) {
  return value.dump(-1, ' ', false, Value::error_handler_t::replace);
}

std::string to_text(const Value& value) {
  return value.dump(2, ' ', false, Value::error_handler_t::replace) + "\n";
}

}  // namespace nazori::json
