// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_workshop.h"

#include <deque>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "nazori/author/collection.h"
#include "nazori/base/latest.h"
#include "nazori/carving/carve.h"
#include "nazori/exchange/own_files.h"
#include "nazori/kanji/own_characters.h"
#include "nazori/kanji/stroke_order.h"

namespace nazori::practice {
namespace {

using std::filesystem::path;

/// The last character and the one before it. A tablet takes 8 MB, and carving one again a few milliseconds.
constexpr std::size_t kRecent = 2;
constexpr std::string_view kBetweenNames = " + ";

base::Result<OwnTablet> load_own(const std::filesystem::path& map_path,
                                 const std::filesystem::path& strokes_path, const OwnTablet& onto,
                                 int grid_size) {
  OwnTablet own;
  exchange::OwnFiles files{map_path, {}, strokes_path, {}, {}};
  if (grid_size > 0) files.grid = grid_size;
  if (!map_path.empty()) {
    own.name = map_path.filename().string();
  } else if (onto.tablet && onto.map_size > 0) {
    files.onto = onto.tablet->height_map();
    own.name = onto.name.substr(0, onto.name.find(kBetweenNames));
  }
  if (!strokes_path.empty()) {
    own.has_strokes = true;
    const std::string name = strokes_path.filename().string();
    own.name = own.name.empty() ? name : own.name + std::string(kBetweenNames) + name;
  }
  auto loaded = exchange::load_own_tablet(std::move(files), TabletWorkshop::kSize);
  if (!loaded) return tl::unexpected(std::move(loaded.error()));
  own.tablet = std::move(loaded->tablet);
  own.map_size = loaded->map_size;
  return own;
}

base::Result<void> save_tablet(const tablet::CarvedTablet& carved, const std::filesystem::path& path,
                               FileFormat format, int size, bool own_map) {
  if (own_map) size = carved.height_map().size();
  if (format == FileFormat::strokes)
    return kanji::StrokeOrder::from_lines(tablet::centre_lines(carved.lines()), size).save(path);
  const surface::HeightMap* map = &carved.height_map();
  surface::HeightMap again;
  if (!own_map && map->size() != size) {
    auto result = carving::carve(tablet::stroke_lines(carved.lines()), size);
    if (!result) return tl::unexpected(result.error());
    again = std::move(*result);
    map = &again;
  }
  return format == FileFormat::raw ? surface::save_raw(*map, path)
                                   : surface::save_png(*map, path, surface::PngDepth::bits_16);
}

struct CarveRequest {
  char32_t code_point;
  std::optional<char32_t> own;  ///< the own character whose form it has
  std::vector<tablet::TabletLine> lines;
};

struct LoadRequest {
  path map_path, strokes_path;
  OwnTablet onto;
  int grid_size;
};

struct CarvedCharacter {
  char32_t code_point;
  Tablet tablet;
};

struct Failure {
  path file;
  base::Error error;
};

using Request = std::variant<CarveRequest, LoadRequest>;
using Answer = std::variant<CarvedCharacter, OwnTablet, Failure>;

/// The most recently carved tablets, newest first.
using Recent = std::deque<CarvedCharacter>;

/// The relief that somebody made: with the widths and depths of its strokes, and the hand's layer.
base::Result<Tablet> carve_own(const path& folder, char32_t code_point) {
  const auto character = author::Collection(folder).find(code_point);
  if (!character) return tl::unexpected(character.error());
  return author::carved_tablet(*character, TabletWorkshop::kSize);
}

Answer answer_to(const CarveRequest& request, const path& own_characters, Recent& recent) {
  if (request.own && !own_characters.empty()) {
    // Not cached: it may be changed at any time.
    auto made = carve_own(own_characters, *request.own);
    if (!made) return Failure{{}, made.error()};
    return CarvedCharacter{request.code_point, *std::move(made)};
  }
  const auto known = std::find_if(recent.begin(), recent.end(), [&request](const CarvedCharacter& c) {
    return c.code_point == request.code_point;
  });
  if (known != recent.end()) return *known;
  auto made = tablet::CarvedTablet::from_lines(request.lines, TabletWorkshop::kSize);
  if (!made) return Failure{{}, made.error()};
  recent.push_front({request.code_point, std::move(*made)});
  if (recent.size() > kRecent) recent.pop_back();
  return recent.front();
}

Answer answer_to(const LoadRequest& request, const path& /*own_characters*/, Recent& /*recent*/) {
  auto own = load_own(request.map_path, request.strokes_path, request.onto, request.grid_size);
  if (!own) return Failure{request.map_path.empty() ? request.strokes_path : request.map_path, own.error()};
  return std::move(*own);
}

}  // namespace

struct TabletWorkshop::Inside {
  Inside(TabletWorkshop& workshop, base::Inbox& inbox, path own_characters)
      : background(std::make_shared<base::Background>("workshop", inbox)),
        latest(
            background,
            [own_characters = std::move(own_characters), recent = std::make_shared<Recent>()](
                const Request& request, const auto&) {
              return std::visit([&](const auto& one) { return answer_to(one, own_characters, *recent); },
                                request);
            },
            [&workshop](const Answer& answer) {
              if (const auto* character = std::get_if<CarvedCharacter>(&answer))
                workshop.carved(character->code_point, character->tablet);
              else if (const auto* own = std::get_if<OwnTablet>(&answer))
                workshop.loaded(*own);
              else if (const auto* failure = std::get_if<Failure>(&answer))
                workshop.failed(failure->file, failure->error);
            }) {}

  std::shared_ptr<base::Background> background;
  base::Latest<Request, Answer> latest;
};

base::Result<TabletWorkshop::GridGuess> TabletWorkshop::guess_grid(
    const std::filesystem::path& strokes_path) {
  const auto guess = exchange::guess_grid(strokes_path);
  if (!guess) return tl::unexpected(guess.error());
  return GridGuess{guess->side, guess->certain};
}

TabletWorkshop::TabletWorkshop(base::Inbox& inbox, path own_characters)
    : inside_(std::make_unique<Inside>(*this, inbox, std::move(own_characters))) {}

TabletWorkshop::~TabletWorkshop() = default;

void TabletWorkshop::carve(const kanji::Character& character) {
  inside_->latest.request(CarveRequest{character.code_point, author::kept_form_of(character),
                                       tablet::tablet_lines(character.lines())});
}

void TabletWorkshop::show(const OwnTablet& own) {
  inside_->latest.cancel();
  loaded(own);
}

void TabletWorkshop::load(const path& map_path, const path& strokes_path, const OwnTablet& onto,
                          int grid_size) {
  inside_->latest.request(LoadRequest{map_path, strokes_path, onto, grid_size});
}

void TabletWorkshop::save(const Tablet& tablet, const path& path, FileFormat format, int size, bool own_map) {
  base::Background& background = *inside_->background;
  background.post([this, &background, tablet, path, format, size, own_map] {
    const auto result = save_tablet(*tablet, path, format, size, own_map);
    background.answer([this, path, result] {
      if (result)
        saved(path);
      else
        failed(path, result.error());
    });
  });
}

}  // namespace nazori::practice
