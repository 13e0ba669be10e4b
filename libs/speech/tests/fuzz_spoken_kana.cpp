// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/speech/spoken_kana.h"

/// Any text is either refused or becomes hiragana, which stay as they are when they are prepared again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto spoken =
      nazori::speech::spoken_kana(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!spoken) return 0;
  const auto text = nazori::base::decode_utf8(spoken->said);
  if (!text || text->empty()) std::abort();
  for (const char32_t c : *text)
    if (!((c >= 0x3041 && c <= 0x3096) || c == U'ー' || c == U'、')) std::abort();
  const auto again = nazori::speech::spoken_kana(spoken->name);
  if (again != spoken) std::abort();
  return 0;
}
