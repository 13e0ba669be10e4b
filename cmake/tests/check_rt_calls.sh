#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fails when a function that runs at the rate of a servo or of a sound card can reach, by whatever calls, anything outside
# the given object files but arithmetic and the time (read from the vDSO, without a system call): an allowlist, so that new
# dangers fail too. Reads the relocations of the objects; one that is not compiled with -ffunction-sections counts as one
# function. What is called through a pointer is not seen: makers' libraries, and the servo that a device calls, which is
# checked by itself.
# usage: check_rt_calls.sh OBJDUMP ROOTS OBJECT...
#   ROOTS  regular expressions with a comma between them, for mangled names; each must match a function.
set -eu
objdump=$1
roots=$2
shift 2
arithmetic='(mem(cpy|set|move)|sqrt|hypot|floor|ceil|fmax|fmin|exp|exp2|expm1|log|log2|pow|sin|cos|sincos|tanh|l?lround|l?lrint|nearbyint|rint|round|trunc|fmod|ldexp)f?'
time='_ZNSt6chrono3_V212steady_clock3nowEv'
compiler='__assert_fail|__stack_chk_fail|_GLOBAL_OFFSET_TABLE_'
for object; do
  echo "OBJECT $object"
  "$objdump" -t -r "$object"
done | awk -v roots="$roots" -v allowed="^($arithmetic|$time|$compiler)\$" '
  $1 == "OBJECT" { object = $2; table = ""; next }
  /^SYMBOL TABLE:/ { table = "symbols"; next }
  /^RELOCATION RECORDS FOR/ {
    table = "relocations"
    from = $4
    sub(/^\[/, "", from)
    sub(/\]:$/, "", from)
    # Jump tables lead back into the function that uses them; the rest is never reached by a call.
    if (from ~ /^\.(rodata|eh_frame|debug|gcc_except_table)/) table = ""
    next
  }
  table == "symbols" && NF >= 4 {
    # VALUE FLAGS SECTION<tab>SIZE [.hidden] NAME; the flags are seven columns, some of them blank.
    section = substr($0, 26)
    sub(/\t.*/, "", section)
    if (section ~ /^\*/) next
    name = $NF
    place[object, name] = object SUBSEP section
    if (substr($0, 18, 1) != "l") everywhere[name] = object SUBSEP section
    if (name !~ /^\./ && section ~ /^\.text/) functions[name] = object SUBSEP section
    sections[object, section] = 1
    next
  }
  table == "relocations" && $1 ~ /^[0-9a-f]+$/ && NF == 3 {
    to = $3
    sub(/[+-]0x[0-9a-f]+$/, "", to)
    key = object SUBSEP from
    if ((key, to) in seen) next
    seen[key, to] = 1
    calls[key] = calls[key] " " to
    next
  }
  function look(node,    at, n, i, names, next_node, queue, first, last) {
    delete visited
    first = last = 1
    queue[1] = node
    visited[node] = 1
    outside = ""
    while (first <= last) {
      at = queue[first++]
      split(at, part, SUBSEP)
      n = split(calls[at], names, " ")
      for (i = 1; i <= n; ++i) {
        if ((part[1], names[i]) in sections) next_node = part[1] SUBSEP names[i]
        else if ((part[1], names[i]) in place) next_node = place[part[1], names[i]]
        else if (names[i] in everywhere) next_node = everywhere[names[i]]
        else {
          if (names[i] !~ allowed) outside = outside " " names[i]
          continue
        }
        # Text among the constants calls nothing.
        if (next_node ~ SUBSEP "\\.rodata") continue
        if (!(next_node in visited)) {
          visited[next_node] = 1
          queue[++last] = next_node
        }
      }
    }
    return outside
  }
  END {
    bad = 0
    count = split(roots, root, ",")
    for (r = 1; r <= count; ++r) {
      matched = 0
      for (name in functions) {
        if (name !~ root[r]) continue
        matched = 1
        outside = look(functions[name])
        if (outside == "") continue
        bad = 1
        print "FROM " name
        n = split(outside, names, " ")
        for (i = 1; i <= n; ++i) print "   reaches " names[i]
      }
      if (!matched) {
        print "no function matches " root[r] # an empty list must not pass
        bad = 2
      }
    }
    exit bad
  }' >"${TMPDIR:-/tmp}/rt_calls.$$" && status=0 || status=$?
if command -v c++filt >/dev/null; then c++filt <"${TMPDIR:-/tmp}/rt_calls.$$"; else cat "${TMPDIR:-/tmp}/rt_calls.$$"; fi
rm -f "${TMPDIR:-/tmp}/rt_calls.$$"
[ "$status" = 0 ] || echo "what runs at the rate of a servo or a sound card must neither allocate, lock, log, throw nor call the system"
exit "$status"
