// SPDX-License-Identifier: Apache-2.0
#include "nazori/json/reader.h"

#include <fmt/format.h>

namespace nazori::json {

void Reader::refuse(const std::string& pointer, std::string what, std::string remedy) {
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

Reader::Object::Object(Reader& reader, const Value& value, std::string pointer)
    : reader_(&reader), value_(&value), pointer_(std::move(pointer)) {
  if (reader.ok() && !value.is_object()) reader.refuse(pointer_, "is not an object", "give { ... }");
}

void Reader::Object::refuse(const char* member, std::string what, std::string remedy) {
  reader_->refuse(pointer_to(member), std::move(what), std::move(remedy));
}

bool Reader::Object::is_there(const char* member) const {
  return value_->is_object() && value_->contains(member);
}

bool Reader::Object::has(const char* member) const {
  return is_there(member) && !(*value_)[member].is_null();
}

const Value* Reader::Object::find(const char* member) {
  if (!reader_->ok()) return nullptr;
  if (!is_there(member)) {
    refuse(member, "is missing");
    return nullptr;
  }
  return &(*value_)[member];
}

std::string Reader::Object::text(const char* member, std::size_t longest) {
  const Value* value = find(member);
  if (value == nullptr) return {};
  if (!value->is_string()) {
    refuse(member, "is not a text");
    return {};
  }
  auto text = value->get<std::string>();
  if (text.size() > longest) {
    refuse(member, fmt::format("is longer than {} bytes", longest));
    return {};
  }
  return text;
}

std::int64_t Reader::Object::whole(const char* member, std::int64_t lowest, std::int64_t highest) {
  const Value* value = find(member);
  if (value == nullptr) return lowest;
  const bool fits = value->is_number_integer() &&
                    (!value->is_number_unsigned() || value->get<std::uint64_t>() <= INT64_MAX);
  if (!fits || value->get<std::int64_t>() < lowest || value->get<std::int64_t>() > highest) {
    refuse(member, to_line(*value).substr(0, 40) + " is not a whole number within its range",
           fmt::format("give {} to {}", lowest, highest));
    return lowest;
  }
  return value->get<std::int64_t>();
}

double Reader::Object::number(const char* member, double lowest, double highest) {
  const Value* value = find(member);
  if (value == nullptr) return lowest;
  if (!value->is_number() || !(value->get<double>() >= lowest && value->get<double>() <= highest)) {
    refuse(member, to_line(*value).substr(0, 40) + " is not a number within its range",
           fmt::format("give {} to {}", lowest, highest));
    return lowest;
  }
  return value->get<double>();
}

bool Reader::Object::truth(const char* member) {
  const Value* value = find(member);
  if (value == nullptr) return false;
  if (!value->is_boolean()) {
    refuse(member, "is neither true nor false");
    return false;
  }
  return value->get<bool>();
}

const Value* Reader::Object::array(const char* member) {
  const Value* value = find(member);
  if (value == nullptr) return nullptr;
  if (!value->is_array()) {
    refuse(member, "is not a list", "give [ ... ]");
    return nullptr;
  }
  return value;
}

std::vector<double> Reader::Object::numbers(const char* member, std::size_t count) {
  const Value* list = array(member);
  if (list == nullptr) return std::vector<double>(count);
  std::vector<double> numbers;
  for (const Value& one : *list)
    if (one.is_number()) numbers.push_back(one.get<double>());
  if (list->size() == count && numbers.size() == count) return numbers;
  refuse(member, "does not hold the numbers it should", fmt::format("give {} numbers", count));
  return std::vector<double>(count);
}

void Reader::Object::read(const char* member, std::string& to) {
  if (!is_there(member)) return;
  if (std::string value = text(member); reader_->ok()) to = std::move(value);
}

void Reader::Object::read(const char* member, bool& to) {
  if (!is_there(member)) return;
  if (const bool value = truth(member); reader_->ok()) to = value;
}

void Reader::Object::read(const char* member, int& to, int lowest, int highest) {
  if (!is_there(member)) return;
  if (const std::int64_t value = whole(member, lowest, highest); reader_->ok()) to = static_cast<int>(value);
}

void Reader::Object::read(const char* member, double& to, double lowest, double highest) {
  if (!is_there(member)) return;
  if (const double value = number(member, lowest, highest); reader_->ok()) to = value;
}

std::string Reader::Object::raw(const char* member) {
  const Value* value = find(member);
  return value == nullptr ? std::string() : to_line(*value);
}

Reader::Object Reader::Object::object(const char* member) {
  static const Value kEmpty = Value::object();
  const Value* value = find(member);
  return {*reader_, value == nullptr ? kEmpty : *value, pointer_to(member)};
}

}  // namespace nazori::json
