// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <string_view>

#include "nazori/paint/paper.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace nazori::paint;
  const auto paper = parse_paper({reinterpret_cast<const char*>(data), size});
  if (!paper) return 0;
  if (!check(*paper)) std::abort();
  const auto again = parse_paper(to_text(*paper));
  if (!again || *again != *paper) std::abort();
  return 0;
}
