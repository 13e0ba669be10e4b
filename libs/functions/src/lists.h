// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// Elements of one list, and points of one statement, at most.
inline constexpr std::size_t kMostElements = 1000;

/// Whether the tree contains a list.
[[nodiscard]] bool has_list(const Expression& e);

/// The number of elements of [1, 2, 3], [1...5] or [1, 3...9]. Nothing where the numbers of a range are not
/// finite or not in equal steps, or the last one is not ahead.
[[nodiscard]] std::optional<std::size_t> element_count(const Node& list);

/// The number of elements of the shortest list in the tree; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> shortest_list(const Expression& e);

/// The tree with the element `i`, from 0, in place of every list.
[[nodiscard]] Expression with_element(const Expression& e, std::size_t i);

/// Puts a statement for each element in place of a statement with lists. Points stay one statement.
/// @return the errors: too many curves or points, a list in a range, several surfaces.
[[nodiscard]] tl::expected<void, SyntaxError> expand_lists(Plot& plot, std::size_t most_statements);

}  // namespace nazori::functions
