// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "json_text.h"
#include "nazori/study/settings.h"

namespace nazori::study {

[[nodiscard]] Json settings_json(const Settings& settings);
/// What is wrong is left in the reader of `object`.
[[nodiscard]] Settings read_settings(JsonReader::Object object);

}  // namespace nazori::study
