// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/exchange/document.h"

namespace nazori::cli {

/// An answer in JSON; its members keep the order in which they were added.
using Json = exchange::Value;
using exchange::to_text;

}  // namespace nazori::cli
