// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <utility>

#include "nazori/base/signal.h"

namespace nazori::ui {

/// Calls `function` for each emission of a base::Signal, until `context` is destroyed. Not named connect(),
/// because QObject::connect() would hide it.
template <class Signal, class Function>
void subscribe(Signal& signal, QObject* context, Function function) {
  struct Held final : QObject {
    Held(QObject* parent, boost::signals2::connection made) : QObject(parent), connection(std::move(made)) {}
    base::Connection connection;
  };
  new Held(context, signal.connect(std::move(function)));
}

}  // namespace nazori::ui
