// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/json/reader.h"
#include "nazori/study/settings.h"

namespace nazori::study {

[[nodiscard]] json::Value settings_json(const Settings& settings);
/// What is wrong is left in the reader of `object`.
[[nodiscard]] Settings read_settings(json::Reader::Object object);

}  // namespace nazori::study
