// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/solid_model.h"
#include "nazori/practice/touch_file.h"

namespace nazori::practice {

/// A solid to make: of tablets, or of a plot.
struct SolidRequest {
  std::vector<SolidTablet> tablets;
  functions::SharedDrawing plot;  ///< null: of the tablets
  SolidSettings settings;         ///< of a plot only the side of the square and the mould count
};

/// A file for a mill, a laser, swell paper or an embosser, as touch_file() and plot_touch_file() make
/// them.
struct TouchRequest {
  TouchKind kind = TouchKind::mill;
  std::vector<LabelledTablet> tablets;
  functions::SharedDrawing plot;  ///< null: of the tablets
  SolidSettings settings;         ///< of a plot only the side of the square counts
  TouchMachines machines;
  std::string subject;
};

/// A solid that was made, and how it looks.
struct SolidView {
  std::shared_ptr<const Solid> solid;
  ReliefPicture picture;
  bool is_watertight = false;
};

/// Makes solids and writes them, on a separate thread. Requests return at once, answers come as signals.
/// Thread: the owner of the inbox.
class SolidMaker {
 public:
  /// Samples of the longer side of a picture.
  static constexpr int kPictureSize = 480;

  /// @param inbox  outlives this.
  explicit SolidMaker(base::Inbox& inbox);
  ~SolidMaker();
  SolidMaker(const SolidMaker&) = delete;
  SolidMaker& operator=(const SolidMaker&) = delete;

  /// `shown` or `refused` follows. Of several requests only the newest is answered.
  void show(SolidRequest request);
  /// Writes a solid as save_solid() does; `saved` or `not_saved` follows.
  void save(std::shared_ptr<const Solid> solid, const std::filesystem::path& path,
            const std::string& subject);
  /// Makes and writes such a file, completely or not at all; `saved` or `not_saved` follows.
  void save(TouchRequest request, const std::filesystem::path& path);

  base::Signal<const SolidView&> shown;
  base::Signal<const base::Error&> refused;
  base::Signal<const std::filesystem::path&> saved;
  base::Signal<const std::filesystem::path&, const base::Error&> not_saved;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::practice
