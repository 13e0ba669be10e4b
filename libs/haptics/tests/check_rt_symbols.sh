#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fails when an object file of the servo thread needs anything from outside but arithmetic, the time (read from the vDSO,
# without a system call) and other functions of the servo: an allowlist, so that new dangers fail too. What the servo
# calls must live in these objects or in headers, so nothing can hide behind a call.
# usage: check_rt_symbols.sh NM OBJECT...
set -eu
nm=$1
shift
allowed='^((mem(cpy|set|move)|sqrt|hypot|floor|ceil|fmax|fmin)f?|std::chrono::_V2::steady_clock::now\(\)|__assert_fail|__stack_chk_fail|_GLOBAL_OFFSET_TABLE_|__(asan|ubsan|tsan)_.*)$'
"$nm" -C "$@" | grep -q ' T .*Servo::tick(' || { echo "no tick() in: $*"; exit 2; } # an empty list must not pass
"$nm" -C "$@" | sed -n 's/^[0-9a-f]* [TWtwVu] //p' | sort -u >"${TMPDIR:-/tmp}/rt_defined.$$"
"$nm" -Cu "$@" | sed -n 's/^ *[Uvw] //p' | sort -u | grep -Fxv -f "${TMPDIR:-/tmp}/rt_defined.$$" | grep -Ev "$allowed" \
  >"${TMPDIR:-/tmp}/rt_needed.$$" || true
needed=$(cat "${TMPDIR:-/tmp}/rt_needed.$$")
rm -f "${TMPDIR:-/tmp}/rt_defined.$$" "${TMPDIR:-/tmp}/rt_needed.$$"
[ -z "$needed" ] || { echo "the servo thread needs from outside:"; echo "$needed"; exit 1; }
