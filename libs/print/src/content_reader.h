// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "canvas.h"
#include "nazori/print/page_drawing.h"

namespace nazori::print {

/// The content of a form object, by its name without the slash.
using ObjectContent = std::function<std::string(std::string_view name)>;

/// Reads the content of a page as a viewer of PDF does. It knows the operators that this room writes: q Q cm
/// Do G g w d J j m l c re S f BT ET Tf Tm Tr Tj. Others are passed over.
/// @param height_mm  of the page, whose lower left corner is the origin of PDF.
void read_content(std::string_view content, double height_mm, Fonts& fonts, const ObjectContent& object,
                  PageDrawing& into);

}  // namespace nazori::print
