// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/learner.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "nazori/study/profiles.h"

namespace nazori::practice {

using Kind = LearnerEvent::Kind;

Learner::Learner(base::Inbox& inbox, Place place)
    : folder_(std::move(place.folder)),
      clock_(std::move(place.clock)),
      book_(std::move(place.characters)),
      upkeep_(inbox) {
  if (!clock_) clock_ = study::system_now;
  if (folder_.empty())
    if (auto known = study::profiles_folder()) folder_ = *std::move(known);
  // A failure is reported by whoever shows characters.
  if (book_.look()) lists_ = std::make_unique<study::CharacterLists>(*book_.database());
  // Until a profile is opened.
  store_.emplace(*study::LearnerStore::in_memory(clock_));
  upkeep_.done.connect([this](const study::UpkeepReport& report) { handle_upkeep(report); });
  upkeep_.failed.connect([this](const base::Error& error) { handle_damage(error); });
}

Learner::~Learner() = default;

std::filesystem::path Learner::file() const {
  const auto path = study::learner_file(folder_, profile_);
  return path ? *path : std::filesystem::path();
}

bool Learner::switch_profile(const std::string& name) {
  if (!study::can_be_profile(name)) {
    LearnerEvent refused = event(Kind::name_refused);
    refused.profile = name;
    announced(refused);
    return false;
  }
  profile_ = name;
  return open_again();
}

bool Learner::open_again() {
  const bool had_trouble = trouble_.has_value();
  const bool is_open = open();
  if (is_open && had_trouble) announced(event(Kind::opened_again));
  profile_changed();
  changed();
  return is_open;
}

void Learner::close() {
  upkeep_.stop();
  store_.emplace(*study::LearnerStore::in_memory(clock_));
  can_write_ = false;
}

void Learner::let_go(LearnerEvent::Kind why) { close_for(event(why)); }

void Learner::close_for(LearnerEvent trouble) {
  close();
  trouble_ = std::move(trouble);
  day_ = store_->today();
  profile_changed();
  changed();
}

void Learner::while_closed(const std::function<std::string()>& work) {
  close();
  if (const std::string next = work(); !next.empty()) profile_ = next;
  open_again();
}

std::vector<std::string> Learner::profiles() const {
  auto names = study::profiles(folder_);
  if (std::find(names.begin(), names.end(), profile_) == names.end()) names.insert(names.begin(), profile_);
  return names;
}

bool Learner::has_profile(const std::string& name) const {
  const auto file = study::learner_file(folder_, name);
  std::error_code ignored;
  return file && std::filesystem::exists(file->parent_path(), ignored);
}

base::Result<void> Learner::rename_profile(const std::string& from, const std::string& to) {
  if (from != profile_) return study::rename_profile(folder_, from, to);
  base::Result<void> done;
  while_closed([&] {
    done = study::rename_profile(folder_, from, to);
    return done ? to : std::string();
  });
  return done;
}

base::Result<std::filesystem::path> Learner::remove_profile(const std::string& name) {
  if (name != profile_) return study::remove_profile(folder_, name);
  base::Result<std::filesystem::path> removed;
  while_closed([&]() -> std::string {
    removed = study::remove_profile(folder_, name);
    if (!removed) return {};
    const auto left = study::profiles(folder_);
    return left.empty() ? std::string(study::kDefaultProfile) : left.front();
  });
  return removed;
}

bool Learner::open() {
  close();  // before opening, because it may be the same file
  trouble_.reset();
  backup_trouble_.reset();
  order_.reset();
  const auto path = folder_.empty() ? study::learner_file("", "") : study::learner_file(folder_, profile_);
  if (!path) {
    trouble_ = folder_.empty() ? event(Kind::no_folder) : event(Kind::no_file, path.error());
  } else if (auto opened =
                 study::LearnerStore::open(*path, study::Access::write, clock_, study::Upkeep::later)) {
    store_.emplace(*std::move(opened));
    can_write_ = true;
    upkeep_.request(*path, store_->today());
  } else {
    trouble_ = trouble_with(opened.error());
    if (auto readable = study::LearnerStore::open(*path, study::Access::read, clock_, study::Upkeep::later))
      store_.emplace(*std::move(readable));
  }
  day_ = store_->today();
  if (trouble_) announced(LearnerEvent(*trouble_));
  return can_write_;
}

LearnerEvent Learner::event(LearnerEvent::Kind kind, base::Error error) const {
  LearnerEvent made;
  made.kind = kind;
  made.profile = profile_;
  made.error = std::move(error);
  return made;
}

LearnerEvent Learner::trouble_with(const base::Error& error) const {
  switch (error.code) {
    case base::Errc::in_use:
      return event(Kind::in_use, error);
    case base::Errc::schema:
      return event(Kind::newer, error);
    case base::Errc::parse:
      return event(Kind::damaged, error);
    default:
      return with_cause(event(Kind::not_writable, error), file());
  }
}

void Learner::announce_unsaved(const base::Error& error) {
  announced(with_cause(event(Kind::not_saved, error), file()));
}

void Learner::announce_unread(const base::Error& error) { announced(event(Kind::unread, error)); }

base::Result<std::span<const char32_t>> Learner::learning_order() {
  const auto& settings = store_->settings();
  if (!order_ || ordered_by_.new_order != settings.new_order || ordered_by_.new_lists != settings.new_lists) {
    order_.reset();
    auto order = lists_ ? lists_->in_learning_order(settings, *store_)
                        : base::Result<std::vector<char32_t>>(std::vector<char32_t>());
    if (!order) return tl::unexpected(std::move(order.error()));
    order_ = *std::move(order);
    ordered_by_ = settings;
  }
  return std::span<const char32_t>(*order_);
}

base::Result<study::DayPlan> Learner::plan() {
  const auto order = learning_order();
  if (!order) return tl::unexpected(order.error());
  return study::plan_day(*store_, *order);
}

void Learner::renew_characters() {
  if (const auto anew = book_.look(); !anew || !*anew) return;
  // Assigned, because others hold the address.
  if (lists_)
    *lists_ = study::CharacterLists(*book_.database());
  else
    lists_ = std::make_unique<study::CharacterLists>(*book_.database());
  renew_order();
}

void Learner::renew_order() {
  order_.reset();
  changed();
}

void Learner::tick() {
  if (store_->today() == day_) return;
  day_ = store_->today();
  // A program that runs for days also needs its daily backups.
  if (can_write_) upkeep_.request(file(), day_);
  changed();
}

void Learner::handle_upkeep(const study::UpkeepReport& report) {
  backup_trouble_.reset();
  if (report.backup_trouble) {
    backup_trouble_ = event(Kind::backup_failed, *report.backup_trouble);
    announced(LearnerEvent(*backup_trouble_));
  }
  changed();
}

void Learner::handle_damage(const base::Error& error) {
  const LearnerEvent trouble = trouble_with(error);
  close_for(trouble);
  announced(trouble);
}

}  // namespace nazori::practice
