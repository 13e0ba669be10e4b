#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fails when lupdate finds a string in the sources that a translation does not hold, when the translation holds one that the
# sources do not, or when an entry moves to another context.
# usage: check_translation.sh TRANSLATION LUPDATE [ARGUMENT]...
#   TRANSLATION  a .ts file; it is not changed
set -eu
translation=$1
shift
copy=$(mktemp -d)
trap 'rm -r "$copy"' EXIT
cp "$translation" "$copy/now.ts"
"$@" -ts "$copy/now.ts" >"$copy/words" 2>&1 || { cat "$copy/words"; exit 1; }
# Compared in order, because lupdate puts a new context where the alphabet wants it.
contents() { grep -E '<(name|source|translation|numerusform)' "$1" | sort; }
contents "$translation" >"$copy/a"
contents "$copy/now.ts" >"$copy/b"
diff "$copy/a" "$copy/b" && exit 0
echo "$translation: run the target nazori_ui_lupdate, and translate what is marked as unfinished"
exit 1
