// SPDX-License-Identifier: Apache-2.0
#include "workplace.h"

#include "desk.h"

namespace nazori::ui {

Workplace::Workplace(Desk& desk) : desk_(desk) {}

Workplace::~Workplace() = default;

void Workplace::save(QSettings& /*settings*/) const {}

bool Workplace::opens(const QStringList& /*paths*/) const { return false; }

void Workplace::open_files(const QStringList& /*paths*/) {}

}  // namespace nazori::ui
