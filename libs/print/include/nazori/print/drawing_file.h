// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "nazori/print/page_drawing.h"

namespace nazori::print {

/// Pages of lines and areas as PDF 1.5 in their true size, without letters: each mark of a page as it is,
/// later ones above earlier ones. The same pages always give the same bytes. Thread-safe: yes.
/// @param pages  at least one. @param title  of the document, UTF-8.
[[nodiscard]] std::string drawing_pdf(std::span<const PageDrawing> pages, std::string_view title);

}  // namespace nazori::print
