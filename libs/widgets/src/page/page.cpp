// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/page/page.h"

#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

Page::Page(WindowParts& parts, Description description)
    : parts_(parts), description_(std::move(description)) {}

Page::~Page() = default;

void Page::save(QSettings& /*settings*/) const {}

bool Page::opens(const QStringList& /*paths*/) const { return false; }

void Page::open_files(const QStringList& /*paths*/) {}

}  // namespace nazori::ui
