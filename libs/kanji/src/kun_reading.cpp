// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kun_reading.h"

namespace nazori::kanji {

KunReading split_kun(std::string_view reading) {
  KunReading out;
  if (reading.starts_with('-')) {
    out.as_suffix = true;
    reading.remove_prefix(1);
  }
  if (reading.ends_with('-')) {
    out.as_prefix = true;
    reading.remove_suffix(1);
  }
  const auto dot = reading.find('.');
  out.stem = reading.substr(0, dot);
  if (dot != std::string_view::npos) out.okurigana = reading.substr(dot + 1);
  return out;
}

std::string kun_text(const KunReading& reading) {
  std::string text = reading.as_suffix ? "～" : "";
  text += reading.stem;
  if (!reading.okurigana.empty()) text += "・" + reading.okurigana;
  if (reading.as_prefix) text += "～";
  return text;
}

}  // namespace nazori::kanji
