// SPDX-License-Identifier: Apache-2.0
#include "study/learner.h"

#include <QFileInfo>
#include <QStorageInfo>
#include <cassert>
#include <utility>

#include "error_text.h"
#include "kanji_text.h"
#include "nazori/study/profiles.h"

namespace nazori::ui {
namespace {

constexpr int kLookAtTheDay_ms = 60'000;
/// With less than this not even the index of a write-ahead log can be made.
constexpr qint64 kLeastRoom = 65'536;

/// Why a store could not be written, in the learner's language where the cause can be seen.
QString cause_of(const base::Error& error, const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::path folder = file.parent_path();
  while (folder.has_relative_path() && !std::filesystem::exists(folder, ignored))
    folder = folder.parent_path();
  const QString name = to_text(folder.string());
  const QStorageInfo disk(name);
  if (disk.isValid() && disk.bytesAvailable() < kLeastRoom)
    return Learner::tr("the disk is full. Make room; what was kept before is safe");
  const bool file_refuses =
      std::filesystem::exists(file, ignored) && !QFileInfo(to_text(file.string())).isWritable();
  if (file_refuses || !QFileInfo(name).isWritable())
    return Learner::tr("%1 may not be written. Check the permissions of the folder").arg(name);
  return reason(error);
}

}  // namespace

Learner::Learner(Place place, QObject* parent)
    : QObject(parent),
      folder_(std::move(place.folder)),
      database_file_(place.database),
      clock_(std::move(place.clock)) {
  if (!clock_) clock_ = study::system_now;
  if (folder_.empty())
    if (auto known = study::profiles_folder()) folder_ = *std::move(known);
  if (auto opened = kanji::KanjiDatabase::open(place.database)) {
    database_.emplace(*std::move(opened));
    lists_ = std::make_unique<study::CharacterLists>(*database_);
  }
  // Until a profile is opened.
  store_.emplace(*study::LearnerStore::in_memory(clock_));
  connect(&day_timer_, &QTimer::timeout, this, &Learner::look_at_the_day);
  day_timer_.start(kLookAtTheDay_ms);
  connect(&upkeep_, &StoreUpkeep::done, this, &Learner::take_upkeep);
  connect(&upkeep_, &StoreUpkeep::failed, this, &Learner::take_damage);
}

Learner::~Learner() = default;

std::filesystem::path Learner::file() const {
  const auto path = study::learner_file(folder_, profile_.toStdString());
  return path ? *path : std::filesystem::path();
}

bool Learner::switch_profile(const QString& name) {
  if (!study::can_be_profile(name.toStdString())) {
    emit said(Feedback::wrong,
              tr("“%1” cannot be the name of a learner: up to 60 bytes, no “/”, and no dot at "
                 "its beginning.")
                  .arg(name));
    return false;
  }
  profile_ = name;
  return open_again();
}

bool Learner::open_again() {
  const bool was_told = !trouble_.isEmpty();
  const bool fine = open();
  if (fine && was_told)
    emit said(Feedback::good, tr("“%1” is open here now: everything is kept.").arg(profile_));
  emit profile_changed();
  emit changed();
  return fine;
}

void Learner::close() {
  upkeep_.stop();
  store_.emplace(*study::LearnerStore::in_memory(clock_));
  can_write_ = false;
}

void Learner::let_go(const QString& sentence) {
  close();
  trouble_ = sentence;
  day_ = store_->today();
  emit profile_changed();
  emit changed();
}

void Learner::while_closed(const std::function<QString()>& work) {
  close();
  if (const QString next = work(); !next.isEmpty()) profile_ = next;
  open_again();
}

bool Learner::open() {
  close();  // before it is opened: it may be the same one
  trouble_.clear();
  backup_trouble_.clear();
  order_.reset();
  const auto path =
      folder_.empty() ? study::learner_file("", "") : study::learner_file(folder_, profile_.toStdString());
  if (!path) {
    trouble_ = folder_.empty() ? tr("No folder for learners is known: set NAZORI_LEARNERS. Nothing is kept.")
                               : reason(path.error());
  } else if (auto opened =
                 study::LearnerStore::open(*path, study::Access::write, clock_, study::Upkeep::later)) {
    store_.emplace(*std::move(opened));
    can_write_ = true;
    upkeep_.request(*path, store_->today());
  } else {
    trouble_ = sentence_about(opened.error());
    if (auto readable = study::LearnerStore::open(*path, study::Access::read, clock_, study::Upkeep::later))
      store_.emplace(*std::move(readable));
  }
  day_ = store_->today();
  if (!trouble_.isEmpty()) emit said(Feedback::wrong, trouble_);
  return can_write_;
}

QString Learner::sentence_about(const base::Error& error) const {
  switch (error.code) {
    case base::Errc::in_use:
      return tr("“%1” is open in another window of Nazori. Close it there; until then nothing is kept here.")
          .arg(profile_);
    case base::Errc::schema:
      return tr("The store of %1 was written by a newer Nazori or another program: %2. Nothing was changed, "
                "and nothing is kept.")
          .arg(profile_, to_text(error.where));
    case base::Errc::parse:
      return tr("The store of %1 is damaged: %2. Nothing was changed. A backup can be put in its place.")
          .arg(profile_, to_text(error.where));
    default:
      return tr("The store of %1 cannot be written: %2. Nothing is kept.")
          .arg(profile_, cause_of(error, file()));
  }
}

void Learner::tell_failure(const base::Error& error) {
  emit said(Feedback::wrong, tr("It could not be kept: %1.").arg(cause_of(error, file())));
}

void Learner::announce_unread(const base::Error& error) {
  emit said(Feedback::wrong, tr("The study data cannot be read: %1.").arg(reason(error)));
}

base::Result<study::DayPlan> Learner::plan() {
  const auto& settings = store_->settings();
  if (!order_ || ordered_by_.new_order != settings.new_order || ordered_by_.new_lists != settings.new_lists) {
    order_.reset();
    auto order = lists_ ? lists_->in_learning_order(settings, *store_)
                        : base::Result<std::vector<char32_t>>(std::vector<char32_t>());
    if (!order) return tl::unexpected(std::move(order.error()));
    order_ = *std::move(order);
    ordered_by_ = settings;
  }
  return study::plan_day(*store_, *order_);
}

void Learner::note_lists() {
  order_.reset();
  emit changed();
}

void Learner::look_at_the_day() {
  if (store_->today() == day_) return;
  day_ = store_->today();
  // A window that is never closed has its daily backups, too.
  if (can_write_) upkeep_.request(file(), day_);
  emit changed();
}

void Learner::take_upkeep(const study::UpkeepReport& report) {
  backup_trouble_.clear();
  if (report.backup_trouble) {
    backup_trouble_ =
        tr("Today's backup could not be made: %1. Studying works.").arg(reason(*report.backup_trouble));
    emit said(Feedback::advice, backup_trouble_);
  }
  emit changed();
}

void Learner::take_damage(const base::Error& error) {
  let_go(sentence_about(error));
  emit said(Feedback::wrong, trouble_);
}

}  // namespace nazori::ui
