// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/practice/statistics_reader.h"
#include "nazori/widgets/page/page.h"

namespace nazori::ui {

class ChartCard;
class ProgressActions;
class ProgressView;

/// The page for progress: charts, each with its numbers.
class Progress final : public Page {
  Q_OBJECT
 public:
  explicit Progress(WindowParts& parts);
  ~Progress() override;

  [[nodiscard]] QString title() const override;
  [[nodiscard]] QWidget* instead_of_tablet() const override;
  [[nodiscard]] ActionSet* actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

  void enter() override;
  void leave() override;
  void refresh_appearance() override;
  void save(QSettings& settings) const override;

  [[nodiscard]] bool is_reading() const { return reader_.is_busy(); }

 private:
  void connect_actions();
  void read();
  void copy(const ChartCard& card);

  ProgressActions* actions_;
  ProgressView* view_;
  practice::StatisticsReader reader_;
  bool entered_ = false;
  bool stale_ = true;
};

}  // namespace nazori::ui
