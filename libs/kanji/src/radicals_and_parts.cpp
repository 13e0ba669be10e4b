// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kanji_database_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kanji_database.h"
#include "radical_sign.h"

namespace nazori::kanji {

std::optional<Radical> KanjiDatabase::radical(int number) const {
  return inside_->answer_or<std::optional<Radical>>(std::nullopt, [&]() -> std::optional<Radical> {
    Rewound row(inside_->radical);
    row->bind(1, number);
    if (!row->executeStep()) return std::nullopt;
    Radical out{number, row.text(0), {}, {}, row.text(2), row.number(1)};
    Rewound form(inside_->radical_forms);
    form->bind(1, number);
    while (form->executeStep()) out.variant_forms.push_back(form.text(0));
    Rewound name(inside_->radical_names);
    name->bind(1, number);
    while (name->executeStep()) out.japanese_names.push_back(name.text(0));
    return out;
  });
}

std::vector<Radical> KanjiDatabase::radicals() const {
  std::vector<int> numbers = inside_->answer_or<std::vector<int>>({}, [&] {
    std::vector<int> out;
    Rewound row(inside_->all_radicals);
    while (row->executeStep()) out.push_back(row.number(0));
    return out;
  });
  std::vector<Radical> all;
  for (const int number : numbers) {
    if (auto one = radical(number)) all.push_back(*std::move(one));
  }
  return all;
}

std::optional<int> KanjiDatabase::Inside::radical_of_form(const std::string& text) {
  const auto letters = base::decode_utf8(text);
  std::string ideograph = text;
  if (letters && letters->size() == 1) {
    if (const auto number = radical_of_sign(letters->front())) return number;
    ideograph = base::encode_utf8(ideograph_of(letters->front()));
  }
  Rewound row(form_of_radical);
  row->bind(1, ideograph);
  return row->executeStep() ? std::optional(row.number(0)) : std::nullopt;
}

std::optional<int> KanjiDatabase::radical_of_form(std::string_view form) const {
  return inside_->answer_or<std::optional<int>>(std::nullopt,
                                                [&] { return inside_->radical_of_form(std::string(form)); });
}

std::int64_t KanjiDatabase::Inside::last_common_word() {
  if (!last_common_word_) {
    // Ids go from the commonest word to the rarest.
    SQLite::Statement last(db, "SELECT coalesce(max(id), -1) FROM word WHERE common <> 0");
    last_common_word_ = last.executeStep() ? last.getColumn(0).getInt64() : -1;
  }
  return *last_common_word_;
}

std::vector<PartUse> KanjiDatabase::parts(int fewest) const {
  return inside_->answer_or<std::vector<PartUse>>({}, [&] {
    std::map<std::string, PartUse> all;
    SQLite::Statement row(
        inside_->db,
        "SELECT e.element, p.strokes, p.place, c.place FROM element_of e JOIN character p "
        "ON p.code_point = unicode(e.element) AND p.strokes > 0 AND length(e.element) = 1 "
        "JOIN character c ON c.place = e.place AND c.strokes > 0 ORDER BY e.element, c.place");
    std::map<std::string, int> own_places;
    while (row.executeStep()) {
      const std::string element = row.getColumn(0).getString();
      PartUse& part = all[element];
      part.element = element;
      part.strokes = row.getColumn(1).getInt();
      own_places[element] = row.getColumn(2).getInt();
      part.characters.push_back(
          inside_->roster().at(static_cast<std::size_t>(row.getColumn(3).getInt())).code_point);
    }
    std::vector<PartUse> out;
    for (auto& [element, part] : all) {
      if (static_cast<int>(part.characters.size()) < fewest) continue;
      const int own = own_places[element];
      const auto at = std::find_if(part.characters.begin(), part.characters.end(), [&](char32_t c) {
        return static_cast<int>(inside_->place_of(c).value_or(0)) > own;
      });
      part.characters.insert(at, inside_->roster().at(static_cast<std::size_t>(own)).code_point);
      out.push_back(std::move(part));
    }
    std::stable_sort(out.begin(), out.end(), [](const PartUse& a, const PartUse& b) {
      return a.strokes != b.strokes ? a.strokes < b.strokes : a.characters.size() > b.characters.size();
    });
    return out;
  });
}

}  // namespace nazori::kanji
