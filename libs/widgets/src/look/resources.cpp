// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/resources.h"

#include <QFile>

// The macro does not work inside a namespace.
static void init_nazori_resources() { Q_INIT_RESOURCE(nazori_widgets); }

namespace nazori::ui {

void open_resources() {
  static const bool once = [] {
    init_nazori_resources();
    return true;
  }();
  static_cast<void>(once);
}

QByteArray read_resource(const QString& name) {
  open_resources();
  QFile file(QStringLiteral(":/nazori/") + name);
  const bool there = file.open(QIODevice::ReadOnly);
  Q_ASSERT(there);
  return there ? file.readAll() : QByteArray();
}

}  // namespace nazori::ui
