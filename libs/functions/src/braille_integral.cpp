// SPDX-License-Identifier: Apache-2.0
#include "braille_writer.h"

namespace nazori::functions {

/// The sign with its ends, lower first, the function and dt. With something behind it in a product it is in
/// parentheses.
void BrailleWriter::integral(const Node& n, bool followed) {
  if (followed) cells_.put(cells_.signs().open);
  cells_.put("⠮");
  if (cells_.is_nemeth()) {
    cells_.go_below();
    write(n.arguments[1]);
    cells_.go_back();
    cells_.go_up();
    write(n.arguments[2]);
    cells_.go_back();
  } else {
    cells_.put("⠢");
    item(n.arguments[1]);
    cells_.put("⠔");
    item(n.arguments[2]);
  }
  part(n.arguments[0], 2, true, false);
  cells_.put_letters(braille_letter('d'));
  write(variable(n.variable));
  if (followed) cells_.put(cells_.signs().close);
}

}  // namespace nazori::functions
