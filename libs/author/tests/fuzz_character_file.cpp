// SPDX-License-Identifier: Apache-2.0
// Any bytes as a document, as its SVG and as a journal; what is read can be written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "journal.h"
#include "nazori/author/character_file.h"
#include "nazori/author/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::author;
  const std::span bytes(data, size);
  (void)parse_character(bytes);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)check_svg(text);
  if (const auto drawn = parse_strokes_svg(text)) {
    const std::string svg = to_strokes_svg(*drawn);
    const auto again = parse_strokes_svg(svg);
    if (!again || to_strokes_svg(*again) != svg) std::abort();
  }
  (void)read_journal(bytes);
  if (const auto change = parse_change(bytes)) (void)to_record(*change);
  (void)import_character(bytes, CharacterFormat::strokes);
  return 0;
}
