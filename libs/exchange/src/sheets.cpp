// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/sheets.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/scan/sheet_reader.h"

namespace nazori::exchange {
namespace {

double rounded(double value) { return std::round(value * 1e3) / 1e3; }

Value shape_of(const writing::InkShape& shape) {
  Value covered = Value::array();
  for (const double share : shape.covered) covered.push_back(rounded(share));
  return {{"size", rounded(shape.size)},       {"right", rounded(shape.offset_x)},
          {"down", rounded(shape.offset_y)},   {"lean_deg", rounded(shape.lean_rad * 180 / std::numbers::pi)},
          {"missing", rounded(shape.missing)}, {"extra", rounded(shape.extra)},
          {"covered", std::move(covered)}};
}

Value cell_of(const scan::CellReading& cell) {
  Value corners = Value::array();
  for (const scan::PhotoPoint p : cell.corners) corners.push_back(Value::array({rounded(p.x), rounded(p.y)}));
  Value remarks = Value::array();
  for (const scan::CellRemark& remark : cell.remarks) {
    Value one{{"flaw", scan::kCellFlaws[static_cast<std::size_t>(remark.flaw)]}};
    one["stroke"] = remark.stroke > 0 ? Value(remark.stroke) : Value(nullptr);
    one["text"] = scan::explain(remark);
    remarks.push_back(std::move(one));
  }
  Value value{{"character", base::encode_utf8(cell.box.character)},
              {"state", scan::kCellStates[static_cast<std::size_t>(cell.state)]}};
  value["looks_like"] = cell.looks_like ? Value(base::encode_utf8(*cell.looks_like)) : Value(nullptr);
  value["remarks"] = std::move(remarks);
  value["shape"] = cell.shape ? shape_of(*cell.shape) : Value(nullptr);
  value["corners"] = std::move(corners);
  return value;
}

}  // namespace

Value to_json(const std::string& photo, std::span<const scan::SheetReading> sheets) {
  Value all = Value::array();
  for (const scan::SheetReading& sheet : sheets) {
    Value cells = Value::array();
    for (const scan::CellReading& cell : sheet.cells) cells.push_back(cell_of(cell));
    all.push_back({{"layout", sheet.mark.layout == print::Layout::quiz ? "quiz" : "practice"},
                   {"page", sheet.mark.page},
                   {"cells", std::move(cells)}});
  }
  return {{"photo", photo}, {"stroke_order_seen", false}, {"sheets", std::move(all)}};
}

}  // namespace nazori::exchange
