// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_document.h"

#include <fmt/format.h>

#include "nazori/base/file.h"
#include "nazori/json/reader.h"
#include "plate_settings.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostBytes = 1'000'000;
constexpr json::Limits kLimits{.bytes = kMostBytes, .depth = 100};

/// Reads what stands under a member that is an object and may be left out.
template <class Read>
void read_inside(json::Reader::Object& object, const char* member, Read read) {
  if (object.is_there(member)) {
    json::Reader::Object inner = object.object(member);
    read(inner);
  }
}

void read_plate(json::Reader::Object& object, PlateSettings& plate) {
  object.read("size", plate.size, 32, 4096);
  object.read("half_width", plate.half_width, 0.001, 0.2);
  object.read("axes", plate.layers.axes);
  object.read("ticks", plate.layers.ticks);
  object.read("grid", plate.layers.grid);
  object.read("rim", plate.layers.rim);
  if (!object.is_there("heights")) return;
  const auto range = object.numbers("heights", 2);
  plate.heights = HeightRange{range[0], range[1]};
  if (!check(plate)) object.refuse("heights", "is no range", "give [low, high] with low < high");
}

void read_sound(json::Reader::Object& object, SoundSettings& sound) {
  object.read("sample_rate", sound.sample_rate, 8000, 192'000);
  object.read("seconds", sound.seconds, 0.2, 60);
  object.read("lowest_hz", sound.lowest_hz, 20, 20'000);
  object.read("highest_hz", sound.highest_hz, 20, 20'000);
  if (!(sound.lowest_hz < sound.highest_hz))
    object.refuse("highest_hz", "is not above lowest_hz", "give more than lowest_hz");
  object.read("volume", sound.volume, 0, 1);
  object.read("earcons", sound.earcons);
}

}  // namespace

std::string to_json(const PlotDocument& d) {
  const Layers& layers = d.plate.layers;
  json::Value plate = {{"size", d.plate.size}, {"half_width", d.plate.half_width},
                       {"axes", layers.axes},  {"ticks", layers.ticks},
                       {"grid", layers.grid},  {"rim", layers.rim}};
  if (d.plate.heights) plate["heights"] = {d.plate.heights->low, d.plate.heights->high};
  const json::Value document = {{"nazori_plot", kPlotDocumentVersion},
                                {"title", d.title},
                                {"expression", d.expression},
                                {"decimal_comma", d.reading.decimal_comma},
                                {"window", {d.window.x0, d.window.x1, d.window.y0, d.window.y1}},
                                {"plate", std::move(plate)},
                                {"sound",
                                 {{"sample_rate", d.sound.sample_rate},
                                  {"seconds", d.sound.seconds},
                                  {"lowest_hz", d.sound.lowest_hz},
                                  {"highest_hz", d.sound.highest_hz},
                                  {"volume", d.sound.volume},
                                  {"earcons", d.sound.earcons}}}};
  return json::to_text(document);
}

base::Result<PlotDocument> parse_document(std::string_view text) {
  const auto document = json::parse(text, kLimits);
  if (!document) {
    base::Error error = document.error();
    error.remedy = "give a saved plot";
    return tl::unexpected(std::move(error));
  }
  if (!document->is_object() || !document->contains("nazori_plot"))
    return base::fail(base::Errc::schema, "this is JSON, but not a plot", "nazori_plot", "give a saved plot");
  const json::Value& version = (*document)["nazori_plot"];
  if (!version.is_number_integer() || version.get<double>() < 1 ||
      version.get<double>() > kPlotDocumentVersion) {
    return base::fail(base::Errc::schema,
                      fmt::format("the plot has version {}, this program reads 1 to {}",
                                  json::to_line(version), kPlotDocumentVersion),
                      "nazori_plot", "use a newer program");
  }
  PlotDocument d;
  json::Reader reader(text);
  json::Reader::Object all = reader.root(*document);
  d.expression = all.text("expression");
  all.read("title", d.title);
  all.read("decimal_comma", d.reading.decimal_comma);
  if (all.is_there("window")) {
    const auto w = all.numbers("window", 4);
    d.window = {w[0], w[1], w[2], w[3]};
    if (!d.window.check())
      all.refuse("window", "is no window", "give [x0, x1, y0, y1] with x0 < x1 and y0 < y1");
  }
  read_inside(all, "plate", [&](json::Reader::Object& plate) { read_plate(plate, d.plate); });
  read_inside(all, "sound", [&](json::Reader::Object& sound) { read_sound(sound, d.sound); });
  if (!reader.ok()) return tl::unexpected(reader.error());
  if (const auto plot = parse(d.expression, d.reading); !plot) {
    base::Error error = plot.error().to_error();
    error.where = "expression, " + error.where;
    return tl::unexpected(std::move(error));
  }
  return d;
}

base::Result<PlotDocument> load_document(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto document = parse_document({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!document) document.error().where = path.string() + ": " + document.error().where;
  return document;
}

base::Result<void> save_document(const PlotDocument& document, const std::filesystem::path& path) {
  return base::write_file(path, to_json(document));
}

}  // namespace nazori::functions
