#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Fails when a source file includes a header from a folder above its own. The order of the folders is a table in a document:
# each row that begins with "| `FOLDER/` |" below the heading is one folder, the lowest first. A folder that the table does not
# name, a row without a folder, a source file outside the folders and an include that names no folder fail too. A public
# header of the module is part of the folder that it lies in; one that lies in none counts as part of the highest.
# usage: check_folders.sh DOCUMENT HEADING SOURCES PUBLIC
#   HEADING  the text of the heading above the table, without "## "
#   SOURCES  the folder that holds the folders
#   PUBLIC   how an include of a public header of the module begins, such as nazori/ui/
set -eu
document=$1
heading=$2
sources=$3
public=$4
order=$(awk -v heading="## $heading" '
  /^## / { inside = ($0 == heading) }
  inside && /^\| `[a-z_]+\/` \|/ {
    name = $2
    gsub(/[`\/]/, "", name)
    print name
  }' "$document")
if [ -z "$order" ]; then
  echo "$document: there is no table of folders below '## $heading'" # an empty table must not pass
  exit 2
fi
cd "$sources"
# One line, because some awks refuse a line break in -v.
order=$(echo $order)
status=0
for folder in $order; do
  [ -d "$folder" ] || { echo "$folder/ is in the table but not in $sources"; status=1; }
done
# FILE:LINE of each include in quotes; a file without one is listed by its name alone.
{
  find . -type f \( -name '*.h' -o -name '*.cpp' \) | sed 's,^\./,,'
  find . -type f \( -name '*.h' -o -name '*.cpp' \) -exec grep -H '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' {} + | sed 's,^\./,,'
} | awk -v order="$order" -v public="$public" '
  BEGIN {
    count = split(order, names, " ")
    for (i = 1; i <= count; ++i) rank[names[i]] = i
  }
  {
    file = $0
    sub(/:.*/, "", file)
    folder = file
    if (!sub(/\/.*/, "", folder)) folder = "(none)"
    if (index($0, ":") == 0) {
      ++files
      if (!(folder in rank)) {
        print file ": its folder is not in the table"
        bad = 1
      }
      next
    }
    included = $0
    sub(/^[^"]*"/, "", included)
    sub(/".*/, "", included)
    to = included
    if (index(included, public) == 1) {
      to = substr(included, length(public) + 1)
      if (!sub(/\/.*/, "", to) || !(to in rank)) to = names[count]
    }
    else if (included ~ /^nazori\//) next # another module; its CMake target decides
    else sub(/\/.*/, "", to)
    if (!(to in rank)) {
      print file " includes \"" included "\", which names no folder of the table"
      bad = 1
    } else if (folder in rank && rank[to] > rank[folder]) {
      print file " includes \"" included "\", but " to "/ is above " folder "/"
      bad = 1
    }
  }
  END {
    if (files == 0) {
      print "there are no source files" # a wrong path must not pass
      bad = 1
    }
    exit bad
  }' || status=1
exit "$status"
