// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <memory>
#include <utility>

#include "nazori/studio/print/relief_view.h"
#include "nazori/studio/print/solid_dialog.h"
#include "page_under_test.h"

namespace nazori::ui::test {

/// The dialog for a model to touch.
class SolidDialogTest : public PageTest {
 protected:
  SolidDialogTest() { window_.resize(1200, 900); }
  void open(SolidSubject subject) {
    dialog_ = std::make_unique<SolidDialog>(parts_, std::move(subject), &window_);
  }
  template <class T>
  T& part(const char* name) {
    return *dialog_->findChild<T*>(QString::fromLatin1(name));
  }
  QString words() { return part<QLabel>("solid_words").text(); }
  void wait_for_model() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return part<QPushButton>("solid_save").isEnabled(); }, 20'000));
  }
  /// The kinds of files that are offered with the ending of the last one, and the name that is proposed.
  std::pair<QStringList, QString> offered() {
    std::pair<QStringList, QString> found;
    choose_file({}, [&found](QFileDialog& files) {
      found.first = files.nameFilters();
      EXPECT_EQ(files.defaultSuffix(), QStringLiteral("3mf"));
      emit files.filterSelected(found.first.back());
      found.first.append(files.defaultSuffix());
      found.second = QFileInfo(files.selectedFiles().value(0)).fileName();
    });
    part<QPushButton>("solid_save").click();
    return found;
  }
  std::unique_ptr<SolidDialog> dialog_;
};

}  // namespace nazori::ui::test
