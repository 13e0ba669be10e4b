// SPDX-License-Identifier: Apache-2.0
#include "reed_solomon.h"

#include <algorithm>
#include <array>

namespace nazori::print {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Field {
  std::array<std::uint8_t, 510> power{};
  std::array<int, 256> log{};
  Field() {
    unsigned x = 1;
    for (std::size_t i = 0; i < 255; ++i) {
      power[i] = power[i + 255] = static_cast<std::uint8_t>(x);
      log[x] = static_cast<int>(i);
      x <<= 1U;
      if (x > 0xFF) x ^= 0x11DU;
    }
  }
};

const Field& field() {
  static const Field kField;
  return kField;
}

std::uint8_t times(std::uint8_t a, std::uint8_t b) {
  if (a == 0 || b == 0) return 0;
  return field().power[static_cast<std::size_t>(field().log[a] + field().log[b])];
}

std::uint8_t inverse(std::uint8_t a) { return field().power[static_cast<std::size_t>(255 - field().log[a])]; }

std::uint8_t power_of_two(std::size_t exponent) { return field().power[exponent % 255]; }

/// The value of a polynomial whose highest coefficient comes first.
std::uint8_t value(std::span<const std::uint8_t> polynomial, std::uint8_t x) {
  std::uint8_t sum = 0;
  for (const std::uint8_t c : polynomial) sum = static_cast<std::uint8_t>(times(sum, x) ^ c);
  return sum;
}

/// The polynomial whose roots are the reciprocals of the places of wrong bytes; lowest coefficient first.
Bytes locator(const Bytes& syndromes) {
  Bytes now{1};
  Bytes before{1};
  std::size_t length = 0;
  std::size_t since = 1;
  std::uint8_t last = 1;
  for (std::size_t n = 0; n < syndromes.size(); ++n) {
    std::uint8_t off = syndromes[n];
    for (std::size_t i = 1; i <= length && i < now.size(); ++i)
      off = static_cast<std::uint8_t>(off ^ times(now[i], syndromes[n - i]));
    if (off == 0) {
      ++since;
      continue;
    }
    const Bytes kept = now;
    const std::uint8_t scale = times(off, inverse(last));
    now.resize(std::max(now.size(), before.size() + since));
    for (std::size_t i = 0; i < before.size(); ++i)
      now[i + since] = static_cast<std::uint8_t>(now[i + since] ^ times(scale, before[i]));
    if (2 * length <= n) {
      length = n + 1 - length;
      before = kept;
      last = off;
      since = 1;
    } else {
      ++since;
    }
  }
  now.resize(length + 1);
  return now;
}

}  // namespace

void append_parity(Bytes& bytes, std::size_t parity) {
  Bytes generator{1};  // highest coefficient first
  for (std::size_t i = 0; i < parity; ++i) {
    generator.push_back(0);
    for (std::size_t k = generator.size() - 1; k > 0; --k)
      generator[k] = static_cast<std::uint8_t>(generator[k] ^ times(generator[k - 1], power_of_two(i)));
  }
  Bytes rest = bytes;
  rest.resize(bytes.size() + parity);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint8_t lead = rest[i];
    for (std::size_t k = 0; k < generator.size(); ++k)
      rest[i + k] = static_cast<std::uint8_t>(rest[i + k] ^ times(lead, generator[k]));
  }
  bytes.insert(bytes.end(), rest.end() - static_cast<std::ptrdiff_t>(parity), rest.end());
}

bool correct(std::span<std::uint8_t> bytes, std::size_t parity) {
  if (bytes.size() > 255 || parity >= bytes.size()) return false;
  Bytes syndromes(parity);
  for (std::size_t i = 0; i < parity; ++i) syndromes[i] = value(bytes, power_of_two(i));
  const auto is_zero = [](std::uint8_t s) { return s == 0; };
  if (std::all_of(syndromes.begin(), syndromes.end(), is_zero)) return true;
  const Bytes places = locator(syndromes);
  const std::size_t wrong = places.size() - 1;
  if (2 * wrong > parity) return false;
  Bytes evaluator(parity);  // syndromes x places, lowest coefficient first
  for (std::size_t i = 0; i < parity; ++i)
    for (std::size_t k = 0; k <= std::min(i, wrong); ++k)
      evaluator[i] = static_cast<std::uint8_t>(evaluator[i] ^ times(places[k], syndromes[i - k]));
  std::size_t found = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::uint8_t x = power_of_two(bytes.size() - 1 - at);
    const std::uint8_t back = inverse(x);
    std::uint8_t sum = 0;
    std::uint8_t slope = 0;  // of the locator: only odd powers remain
    std::uint8_t of_evaluator = 0;
    std::uint8_t power = 1;
    for (std::size_t k = 0; k < std::max(places.size(), parity); ++k) {
      if (k < places.size()) sum = static_cast<std::uint8_t>(sum ^ times(places[k], power));
      if (k + 1 < places.size() && k % 2 == 0)
        slope = static_cast<std::uint8_t>(slope ^ times(places[k + 1], power));
      if (k < parity) of_evaluator = static_cast<std::uint8_t>(of_evaluator ^ times(evaluator[k], power));
      power = times(power, back);
    }
    if (sum != 0) continue;
    if (slope == 0) return false;
    ++found;
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ times(x, times(of_evaluator, inverse(slope))));
  }
  if (found != wrong) return false;
  for (std::size_t i = 0; i < parity; ++i)
    if (value(bytes, power_of_two(i)) != 0) return false;
  return true;
}

}  // namespace nazori::print
