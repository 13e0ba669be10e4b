// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

// What the static analysis sees of signal.h. It does not follow reference counts that are kept atomically, so
// it takes every connection of Boost for memory that is used after it was freed. These declarations have no
// bodies to follow.

namespace boost::signals2 {

/// As Boost's.
class connection {
 public:
  connection();
  connection(const connection& other);
  connection& operator=(const connection& other);
  ~connection();
  void disconnect() const;
};

/// As Boost's: ends the connection with itself.
class scoped_connection {
 public:
  scoped_connection();
  scoped_connection(const connection& other);  // NOLINT(google-explicit-constructor): as in Boost
  scoped_connection(scoped_connection&& other) noexcept;
  scoped_connection& operator=(scoped_connection&& other) noexcept;
  scoped_connection& operator=(const connection& other);
  ~scoped_connection();
  void disconnect() const;
};

}  // namespace boost::signals2

namespace nazori::base {

/// As in signal.h.
using Connection = boost::signals2::scoped_connection;

/// As in signal.h.
template <class... Arguments>
class Signal {
 public:
  boost::signals2::connection connect(const std::function<void(Arguments...)>& function);
  void operator()(Arguments... arguments) const;
};

}  // namespace nazori::base
