// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

namespace nazori::ui {

/// Makes what lies under ":/nazori" readable; a static library's resources are not there by themselves.
/// Cheap to call again.
void open_resources();

/// A file of libs/ui/resources. @param name  "icons/eye.svg"; a file that is not there is a programming
/// error and reads as empty.
[[nodiscard]] QByteArray read_resource(const QString& name);

}  // namespace nazori::ui
