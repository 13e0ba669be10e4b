// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/signals2/connection.hpp>
#include <boost/signals2/dummy_mutex.hpp>
#include <boost/signals2/signal_type.hpp>

namespace nazori::base {

/// An event to which any number of functions may be connected: `signal.connect(function)`,
/// `signal(arguments...)`. It has no lock: one thread connects, emits and disconnects. Functions run in the
/// order in which they were connected; a function may connect or disconnect others while it runs.
template <class... Arguments>
using Signal = typename boost::signals2::signal_type<
    void(Arguments...), boost::signals2::keywords::mutex_type<boost::signals2::dummy_mutex>>::type;

/// A connection that ends when this is destroyed or assigned to.
using Connection = boost::signals2::scoped_connection;

}  // namespace nazori::base
