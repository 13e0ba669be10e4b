// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/sample_csv.h"

#include <array>
#include <charconv>
#include <cstring>

namespace nazori::recording {
namespace {

// In the order of the bits of haptics::ServoEvent.
constexpr std::array<std::string_view, 11> kEvents{
    "touch",           "untouch",     "capture",     "release",  "fault",  "wrong_start",
    "wrong_direction", "stroke_done", "lesson_done", "resisted", "resumed"};

// The longest shortest text of a double is "-2.2250738585072014e-308".
constexpr std::size_t kLongestNumber = 24;
constexpr std::size_t kLongestRow = 10 * (kLongestNumber + 1) + 40;

char* put(char* to, double value) {
  if (value == 0) {  // a quarter of all numbers: forces above the tablet. -0 is 0.
    *to = '0';
    return to + 1;
  }
  return std::to_chars(to, to + kLongestNumber, value).ptr;
}

char* copy(char* to, const char* from, std::size_t length) {
  std::memcpy(to, from, length);
  return to + length;
}

}  // namespace

std::string_view event_name(int bit) {
  return bit >= 0 && bit < static_cast<int>(kEvents.size()) ? kEvents[static_cast<std::size_t>(bit)]
                                                            : std::string_view();
}

std::string event_words(std::uint32_t events) {
  std::string words;
  for (int bit = 0; bit < 32; ++bit) {
    if ((events >> bit & 1U) == 0) continue;
    const std::string_view name = event_name(bit);
    if (!words.empty()) words += '|';
    if (name.empty())
      words.append("bit").append(std::to_string(bit));
    else
      words.append(name);
  }
  return words;
}

void append_csv_row(std::string& text, const haptics::ServoSample& sample) {
  std::array<char, kLongestRow> row;
  char* at = put(row.data(), sample.time_s);
  std::array<const char*, 3> starts{};
  std::array<std::size_t, 3> lengths{};
  for (int axis = 0; axis < 3; ++axis) {
    *at++ = ',';
    char* const start = at;
    at = put(at, sample.device_m[axis]);
    starts[static_cast<std::size_t>(axis)] = start;
    lengths[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(at - start);
  }
  for (int axis = 0; axis < 3; ++axis) {
    *at++ = ',';
    // Above the tablet the proxy is the device; copying its text is faster than formatting it again.
    const auto i = static_cast<std::size_t>(axis);
    at = sample.proxy_m[axis] == sample.device_m[axis] ? copy(at, starts[i], lengths[i])
                                                       : put(at, sample.proxy_m[axis]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    *at++ = ',';
    at = put(at, sample.force_n[axis]);
  }
  *at++ = ',';
  *at++ = sample.touching ? '1' : '0';
  *at++ = ',';
  at = std::to_chars(at, row.data() + row.size(), sample.stroke).ptr;
  *at++ = ',';
  text.append(row.data(), static_cast<std::size_t>(at - row.data()));
  if (sample.events != 0) text += event_words(sample.events);
  text += '\n';
}

}  // namespace nazori::recording
