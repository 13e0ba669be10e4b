// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_document.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "nazori/base/file.h"
#include "nazori/base/nesting.h"
#include "plate_settings.h"

namespace nazori::functions {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1'000'000;
constexpr int kDeepest = 100;

/// Reads members and remembers the first that is wrong.
class MemberReader {
 public:
  explicit MemberReader(const Json& object, std::string prefix = "")
      : object_(object), prefix_(std::move(prefix)) {}

  void read(const char* name, std::string& to) {
    if (const Json* v = find(name))
      v->is_string() ? void(to = v->get<std::string>()) : refuse(name, "a text");
  }
  void read(const char* name, bool& to) {
    if (const Json* v = find(name))
      v->is_boolean() ? void(to = v->get<bool>()) : refuse(name, "true or false");
  }
  void read(const char* name, int& to, int least, int most) {
    const Json* v = find(name);
    if (v == nullptr) return;
    const double value = v->is_number() ? v->get<double>() : std::nan("");
    if (value >= least && value <= most && value == std::floor(value)) {
      to = static_cast<int>(value);
    } else {
      refuse(name, fmt::format("a whole number from {} to {}", least, most));
    }
  }
  void read(const char* name, double& to, double least, double most) {
    const Json* v = find(name);
    if (v == nullptr) return;
    const double value = v->is_number() ? v->get<double>() : std::nan("");
    value >= least&& value <= most ? void(to = value)
                                   : refuse(name, fmt::format("a number from {} to {}", least, most));
  }
  template <std::size_t N>
  [[nodiscard]] std::optional<std::array<double, N>> numbers(const char* name) {
    const Json* v = find(name);
    if (v == nullptr) return std::nullopt;
    std::array<double, N> values{};
    bool good = v->is_array() && v->size() == N;
    for (std::size_t i = 0; good && i < N; ++i) {
      good = (*v)[i].is_number();
      if (good) values[i] = (*v)[i].template get<double>();
    }
    if (!good) {
      refuse(name, fmt::format("{} numbers in brackets", N));
      return std::nullopt;
    }
    return values;
  }
  [[nodiscard]] MemberReader inside(const char* name) {
    static const Json kNone = Json::object();
    const Json* v = find(name);
    if (v != nullptr && !v->is_object()) refuse(name, "an object");
    return MemberReader(v != nullptr && v->is_object() ? *v : kNone, prefix_ + name + ".");
  }
  void take_error(const MemberReader& other) {
    if (!error_) error_ = other.error_;
  }
  void refuse(const char* name, std::string wanted) {
    if (error_) return;
    error_ = base::Error{base::Errc::bad_argument, fmt::format("\"{}{}\" has a wrong value", prefix_, name),
                         prefix_ + name, "give " + std::move(wanted)};
  }
  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }

 private:
  const Json* find(const char* name) {
    const auto at = object_.find(name);
    return at == object_.end() ? nullptr : &*at;
  }

  const Json& object_;
  std::string prefix_;
  std::optional<base::Error> error_;
};

/// "line 3, column 7" of a byte.
std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last = before.rfind('\n');
  return fmt::format("line {}, column {}", line,
                     last == before.npos ? before.size() : before.size() - last - 1);
}

}  // namespace

std::string to_json(const PlotDocument& d) {
  const Layers& layers = d.plate.layers;
  Json plate = {{"size", d.plate.size}, {"half_width", d.plate.half_width},
                {"axes", layers.axes},  {"ticks", layers.ticks},
                {"grid", layers.grid},  {"rim", layers.rim}};
  if (d.plate.heights) plate["heights"] = {d.plate.heights->low, d.plate.heights->high};
  const Json document = {{"nazori_plot", kPlotDocumentVersion},
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
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

base::Result<PlotDocument> parse_document(std::string_view text) {
  // A hostile nest of brackets would overrun the stack when it is freed.
  if (base::is_nested_deeper(text, kDeepest))
    return base::fail(base::Errc::parse, "the JSON is nested too deep", "document");
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    return base::fail(base::Errc::parse, "this is not JSON", place_of(text, e.byte), "give a saved plot");
  } catch (const Json::out_of_range&) {
    return base::fail(base::Errc::parse, "a number is too large", "document", "give a saved plot");
  }
  if (!json.is_object() || !json.contains("nazori_plot")) {
    return base::fail(base::Errc::schema, "this is JSON, but not a plot", "nazori_plot", "give a saved plot");
  }
  const Json& version = json["nazori_plot"];
  if (!version.is_number_integer() || version.get<double>() < 1 ||
      version.get<double>() > kPlotDocumentVersion) {
    return base::fail(base::Errc::schema,
                      fmt::format("the plot has version {}, this program reads 1 to {}", version.dump(),
                                  kPlotDocumentVersion),
                      "nazori_plot", "use a newer program");
  }
  PlotDocument d;
  MemberReader all(json);
  if (!json.contains("expression")) all.refuse("expression", "a text such as \"y = sin(x)\"");
  all.read("title", d.title);
  all.read("expression", d.expression);
  all.read("decimal_comma", d.reading.decimal_comma);
  if (const auto w = all.numbers<4>("window")) {
    d.window = {(*w)[0], (*w)[1], (*w)[2], (*w)[3]};
    if (!d.window.check()) all.refuse("window", "[x0, x1, y0, y1] with x0 < x1 and y0 < y1");
  }
  MemberReader plate = all.inside("plate");
  plate.read("size", d.plate.size, 32, 4096);
  plate.read("half_width", d.plate.half_width, 0.001, 0.2);
  plate.read("axes", d.plate.layers.axes);
  plate.read("ticks", d.plate.layers.ticks);
  plate.read("grid", d.plate.layers.grid);
  plate.read("rim", d.plate.layers.rim);
  if (const auto h = plate.numbers<2>("heights")) {
    d.plate.heights = HeightRange{(*h)[0], (*h)[1]};
    if (!check(d.plate)) plate.refuse("heights", "[low, high] with low < high");
  }
  all.take_error(plate);
  MemberReader sound = all.inside("sound");
  sound.read("sample_rate", d.sound.sample_rate, 8000, 192'000);
  sound.read("seconds", d.sound.seconds, 0.2, 60);
  sound.read("lowest_hz", d.sound.lowest_hz, 20, 20'000);
  sound.read("highest_hz", d.sound.highest_hz, 20, 20'000);
  if (!(d.sound.lowest_hz < d.sound.highest_hz)) sound.refuse("highest_hz", "more than lowest_hz");
  sound.read("volume", d.sound.volume, 0, 1);
  sound.read("earcons", d.sound.earcons);
  all.take_error(sound);
  if (all.error()) return tl::unexpected(*all.error());
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
