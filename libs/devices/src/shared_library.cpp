// SPDX-License-Identifier: Apache-2.0
#include "shared_library.h"

#include <dlfcn.h>

namespace nazori::devices {

DeviceResult<SharedLibrary> SharedLibrary::load(const std::string& what,
                                                const std::vector<std::string>& names,
                                                const std::string& remedy) {
  std::string tried, telling;
  for (const std::string& name : names) {
    if (name.empty()) continue;
    // RTLD_GLOBAL, because the makers' libraries use each other's symbols.
    if (void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_GLOBAL); handle != nullptr)
      return SharedLibrary(handle, what, name, remedy);
    const char* words = dlerror();  // NOLINT(concurrency-mt-unsafe): its state is kept for each thread
    const std::string reason = words != nullptr ? words : "";
    // "x: cannot open shared object file: No such file" for x itself adds nothing to the list.
    if (telling.empty() &&
        (reason.rfind(name + ": cannot open", 0) != 0 || reason.find("No such file") == std::string::npos))
      telling = reason;
    tried += (tried.empty() ? "" : ", ") + name;
  }
  if (!telling.empty())
    return no_device(haptics::DeviceTrouble::library_missing,
                     "the library was found but cannot be loaded: " + telling, what, remedy);
  return no_device(haptics::DeviceTrouble::library_missing, "the library was not found (tried " + tried + ")",
                   what, remedy);
}

void* SharedLibrary::find(const char* name) const { return dlsym(handle_, name); }

DeviceResult<void> SharedLibrary::missing(const char* name) const {
  return no_device(haptics::DeviceTrouble::symbol_missing,
                   path_ + " has no function " + name + ": it is the wrong library or version", what_,
                   remedy_);
}

}  // namespace nazori::devices
