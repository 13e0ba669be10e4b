// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Absolute paths that a test program or benchmark reads. nazori_test_paths() of cmake/NazoriModule.cmake
/// defines those that a program uses, in a generated file. They are not macros, because a macro with the path
/// of a checkout would keep a compiler cache from recognising the sources in another folder.
namespace nazori::test_paths {

extern const char* const kFixtures;         ///< tests/fixtures of the module
extern const char* const kCarvingFixtures;  ///< tests/fixtures of the module carving
extern const char* const kStandins;         ///< folder of the stand-ins for the makers' libraries
extern const char* const kCommandLine;      ///< the program nazori-cli
extern const char* const kSources;          ///< the source tree
extern const char* const kDocs;             ///< docs/ of the source tree
extern const char* const kTranslations;     ///< folder of the window's translations

}  // namespace nazori::test_paths
