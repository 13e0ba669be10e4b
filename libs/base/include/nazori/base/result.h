// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace nazori::base {

/// What kind of thing went wrong. Callers branch on this, never on the text.
enum class Errc : std::uint8_t {
  bad_argument,  ///< the caller gave a value outside the allowed range
  io,            ///< the file system or another outside service refused
  parse,         ///< data do not follow their format
  schema,        ///< data follow their format but are of the wrong kind or version
  not_found,     ///< the requested item does not exist
  device,        ///< a haptic or graphics device failed
  cancelled,     ///< the user stopped the work
  in_use,        ///< another program has it open; trying again later may help
};

/// A failure that the caller is expected to handle. The texts are English, for logs and the command line; the
/// window translates by `code`.
struct Error {
  Errc code = Errc::bad_argument;
  std::string what;    ///< what happened: one sentence, no trailing newline
  std::string where;   ///< the item in question: "休.raw", "edict:1042", "--size"; may be empty
  std::string remedy;  ///< how to put it right: "give --map-size", may be empty

  friend bool operator==(const Error&, const Error&) = default;
};

/// A value, or the error that says why there is none. Every function that returns one is [[nodiscard]].
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning a failure from a function that returns a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(Errc code, std::string what, std::string where = {},
                                                std::string remedy = {}) {
  return tl::unexpected<Error>(Error{code, std::move(what), std::move(where), std::move(remedy)});
}

/// The error in one line for people: "where: what (remedy)". Parts that are empty are left out, control
/// characters and line breaks inside become spaces.
[[nodiscard]] std::string to_line(const Error& error);

}  // namespace nazori::base
