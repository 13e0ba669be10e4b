// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "nazori/haptics/servo.h"

namespace nazori::recording {

/// First line of a CSV of samples, with its line feed. SI, tablet frame; `contact` is 0 or 1, `stroke` the
/// number of the stroke that attracts the stylus or 0, `event` the events, see event_words.
inline constexpr std::string_view kSampleCsvHeader =
    "t,x,y,z,proxy_x,proxy_y,proxy_z,fx,fy,fz,contact,stroke,event\n";

/// Appends one row. Numbers are the shortest text that reads back as the same number, whatever the locale; so
/// the same samples give the same bytes.
void append_csv_row(std::string& text, const haptics::ServoSample& sample);

/// Names of ServoEvent bits joined by '|' ("touch|capture"), empty for none; a bit without a name is "bit12".
/// @return the names in the order of the bits.
[[nodiscard]] std::string event_words(std::uint32_t events);

/// Name of the ServoEvent of bit `bit`, empty where it has none.
[[nodiscard]] std::string_view event_name(int bit);

}  // namespace nazori::recording
