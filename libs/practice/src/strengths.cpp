// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/strengths.h"

#include <algorithm>
#include <array>
#include <map>

namespace nazori::practice {
namespace {

using study::Strength;

constexpr std::array kFirmestFirst{Strength::mature, Strength::young,  Strength::learning,
                                   Strength::leech,  Strength::paused, Strength::unseen};

constexpr Colour plain(ColourRole role) { return {role, role, 0}; }
constexpr Colour on_surface(ColourRole over, double share) { return {ColourRole::surface, over, share}; }

}  // namespace

StrengthLook look_of(Strength strength) {
  switch (strength) {
    case Strength::unseen:
      return {plain(ColourRole::surface), plain(ColourRole::muted), 0, true};
    case Strength::learning:
      return {on_surface(ColourRole::accent, 0.10), plain(ColourRole::text), U'◔', false};
    case Strength::young:
      return {on_surface(ColourRole::accent, 0.30), plain(ColourRole::text), U'◑', false};
    case Strength::mature:
      return {plain(ColourRole::accent), plain(ColourRole::surface), U'●', false};
    case Strength::leech:
      return {on_surface(ColourRole::warning, 0.22), plain(ColourRole::text), U'!', false};
    case Strength::paused:
      return {plain(ColourRole::paper), plain(ColourRole::muted), U'‖', true};
  }
  return {};
}

double bar_of(Strength strength) {
  switch (strength) {
    case Strength::learning:
    case Strength::leech:
      return 0.3;
    case Strength::young:
      return 0.6;
    case Strength::mature:
      return 1;
    case Strength::unseen:
    case Strength::paused:
      return 0;
  }
  return 0;
}

std::vector<study::CharacterState> states_of(std::span<const char32_t> characters,
                                             const study::Statistics& statistics) {
  std::map<char32_t, study::CharacterState> studied;
  for (const auto& state : statistics.characters) studied.emplace(state.character, state);
  std::vector<study::CharacterState> states;
  states.reserve(characters.size());
  for (const char32_t character : characters) {
    const auto found = studied.find(character);
    states.push_back(found != studied.end() ? found->second
                                            : study::CharacterState{character, Strength::unseen, 0});
  }
  return states;
}

std::vector<std::pair<Strength, int>> count_by_strength(std::span<const study::CharacterState> states) {
  std::vector<std::pair<Strength, int>> counts;
  for (const auto strength : kFirmestFirst) {
    const auto count = std::count_if(states.begin(), states.end(),
                                     [strength](const auto& state) { return state.strength == strength; });
    if (count > 0) counts.emplace_back(strength, static_cast<int>(count));
  }
  return counts;
}

}  // namespace nazori::practice
