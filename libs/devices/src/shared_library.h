// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// A maker's library, found at run time. Stays loaded until the program ends: some cannot be loaded twice.
class SharedLibrary {
 public:
  /// Tries the names in order and loads the first one possible.
  /// @param what  "OpenHaptics".  @param remedy  what to install.
  /// @return DeviceTrouble::library_missing with the names that were tried, or with the loader's message
  /// where one of them was found but does not load.
  [[nodiscard]] static DeviceResult<SharedLibrary> load(const std::string& what,
                                                        const std::vector<std::string>& names,
                                                        const std::string& remedy);

  /// Sets `function` to the function of that name. @return DeviceTrouble::symbol_missing.
  template <class F>
  [[nodiscard]] DeviceResult<void> need(F*& function, const char* name) const {
    function = reinterpret_cast<F*>(find(name));
    if (function == nullptr) return missing(name);
    return {};
  }
  /// The same for a function that may be missing: null then.
  template <class F>
  void want(F*& function, const char* name) const {
    function = reinterpret_cast<F*>(find(name));
  }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  SharedLibrary(void* handle, std::string what, std::string path, std::string remedy)
      : handle_(handle), what_(std::move(what)), path_(std::move(path)), remedy_(std::move(remedy)) {}
  [[nodiscard]] void* find(const char* name) const;
  [[nodiscard]] DeviceResult<void> missing(const char* name) const;

  void* handle_;
  std::string what_, path_, remedy_;
};

}  // namespace nazori::devices
