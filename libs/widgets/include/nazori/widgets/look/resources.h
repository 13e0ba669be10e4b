// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

namespace nazori::ui {

/// Makes the resources under ":/nazori" readable. Those of a static library must be initialised. Cheap to
/// call again.
void open_resources();

/// A file of libs/ui/resources. @param name  "icons/eye.svg"; a file that is not there is a programming
/// error and reads as empty.
[[nodiscard]] QByteArray read_resource(const QString& name);

}  // namespace nazori::ui
