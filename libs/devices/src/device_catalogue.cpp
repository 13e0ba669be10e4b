// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/device_catalogue.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace nazori::devices {
namespace {

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

/// The back end's name before the colon, or all of it.
std::string_view back_end_of(std::string_view id) { return id.substr(0, id.find(':')); }

}  // namespace

DeviceCatalogue::DeviceCatalogue(std::vector<std::unique_ptr<BackEnd>> back_ends)
    : back_ends_(std::move(back_ends)) {}

std::vector<BackEndFindings> DeviceCatalogue::find() {
  std::vector<BackEndFindings> all;
  all.reserve(back_ends_.size());
  for (const auto& back_end : back_ends_) all.push_back(back_end->find());
  return all;
}

DeviceResult<OpenedDevice> DeviceCatalogue::open(std::string_view name, const OpenRequest& request) {
  for (const auto& back_end : back_ends_) {
    if (lower(back_end_of(name)) == back_end->id()) return back_end->open(name, request);
  }
  const std::string wanted = lower(name);
  std::string there;
  for (const auto& back_end : back_ends_) {
    for (const FoundDevice& device : back_end->find().devices) {
      if (!wanted.empty() && lower(device.name).find(wanted) != std::string::npos)
        return back_end->open(device.id, request);
      there += (there.empty() ? "" : ", ") + device.id;
    }
  }
  return no_device(haptics::DeviceTrouble::device_absent, "no device has this name", std::string(name),
                   there.empty() ? "no devices were found" : "available: " + there);
}

BestDevice DeviceCatalogue::open_best(std::string_view preferred, const OpenRequest& request,
                                      std::string_view avoid) {
  BestDevice best{{}, no_device(haptics::DeviceTrouble::device_absent, "no device was found", "", "")};
  if (!preferred.empty()) {
    best.opened = open(preferred, request);
    if (best.opened) return best;
    best.passed_over.push_back(best.opened.error());
  }

  struct Candidate {
    BackEnd* back_end;
    FoundDevice device;
  };
  std::vector<Candidate> candidates;
  for (const auto& back_end : back_ends_) {
    BackEndFindings found = back_end->find();
    if (found.problem) best.passed_over.push_back(*found.problem);
    for (FoundDevice& device : found.devices) {
      if (device.automatic) candidates.push_back({back_end.get(), std::move(device)});
    }
  }
  const auto rank = [&](const Candidate& c) {
    return (c.device.id == avoid ? 2 : 0) + (c.device.has_force ? 0 : 1);
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
  // A calibration fits one device only.
  OpenRequest fitted = request;
  if (!preferred.empty()) fitted.calibration.reset();
  for (const Candidate& candidate : candidates) {
    best.opened = candidate.back_end->open(candidate.device.id, fitted);
    if (best.opened) return best;
    best.passed_over.push_back(best.opened.error());
  }
  return best;
}

}  // namespace nazori::devices
