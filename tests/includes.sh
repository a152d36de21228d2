#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# includes.sh - the order of the folders in src/, read from the #include "..." lines.
#
#   base < mechanics < synthesis < deck < motion < results    the library: a folder includes from itself and from
#                                                             those below it
#   system < view < drawing < tables, pictures < report < command       the command: of the library, only fourlink.h and base/
#
# tables and pictures do not include each other, and no file includes itself by way of others, where a
# header and its source count as one file.  Headers of an operating system are for system/system_*.c alone.
# The command has memory from system/memory.c, and by way of view/results.c calls the functions of fourlink.h that need
# some: there it is noted that memory failed.
# Prints each offender; exits with 1 if there is one.
set -u
cd "$(dirname "$0")/.." || exit 1

awk '
BEGIN {
  allowed["base"] = "base"
  allowed["mechanics"] = "mechanics base"
  allowed["synthesis"] = "synthesis mechanics base"
  allowed["deck"] = "deck synthesis mechanics base"
  allowed["motion"] = "motion deck mechanics base"
  allowed["results"] = "results motion deck mechanics base"
  allowed["system"] = "system base"
  allowed["view"] = "view system base"
  allowed["tables"] = "tables view system base"
  allowed["drawing"] = "drawing view system base"
  allowed["pictures"] = "pictures drawing view system base"
  allowed["report"] = "report tables pictures drawing view system base"
  allowed["command"] = "command report tables pictures drawing view system base"
  for (i = 1; i < ARGC; i++)
    present[ARGV[i]] = 1
}

FNR == 1 {
  file = FILENAME
  folder = file ~ /^src\/[^\/]*\// ? part(file, 2) : ""
  if (!(folder in allowed))
    offend("", file ": not in one of the folders of src/")
  else
    seen[folder] = 1
}

/^[ \t]*#[ \t]*include[ \t]*<(sys\/|unistd|fcntl|windows|io\.h|dirent|glob|poll|pthread|termios)/ && file !~ /^src\/system\/system_/ {
  offend("system", file ":" FNR ": includes a header of the operating system")
}

folder ~ /^(system|view|drawing|tables|pictures|report|command)$/ && file !~ /^src\/(system\/(system_|memory)|view\/results)/ &&
/(^|[^a-z_])((m|c|re)alloc|strdup|fourlink_(results_(open|open_like|design|set|set_text|put|get|value|facts|check)|deck_read|extreme))\(/ {
  offend("memory", file ":" FNR ": memory is taken from system/memory.h, or by way of view/results.h")
}

# Includes of the project, by path.  A name without a folder is a neighbour, or the public header.
/^[ \t]*#[ \t]*include[ \t]*"/ {
  name = $0
  sub(/^[^"]*"/, "", name)
  sub(/".*/, "", name)
  if (name == "fourlink.h")
    next
  n++
  from[n] = file
  to[n] = name ~ /\// ? "src/" name : "src/" folder "/" name
  line[n] = FNR
}

END {
  for (i = 1; i <= n; i++) {
    folder = part(from[i], 2)
    where = from[i] ":" line[i] ": includes " substr(to[i], 5)
    if (!(to[i] in present))
      offend(folder, where ", which is not in src/")
    else if (index(" " allowed[folder] " ", " " part(to[i], 2) " ") == 0)
      offend(folder, where)
    link(unit(from[i]), unit(to[i]))
  }
  find_circle()
  for (folder in seen)
    checks++
  checks += 4 # every file has a folder; no circle; systems; memory
  for (what in bad)
    failed++
  print checks - failed " passed, " failed + 0 " failed"
  exit failed > 0
}

function part(path, i,   parts) { split(path, parts, "/"); return parts[i] }

# A header and its source are one unit.
function unit(path) { sub(/\.[ch]$/, "", path); return path }

function offend(what, message) { bad[what] = 1; print message }

function link(a, b) {
  if (a != b && !((a, b) in edge)) {
    edge[a, b] = 1
    next_of[a, ++n_next[a]] = b
    units[a] = units[b] = 1
  }
}

# What includes nothing that is left cannot be in a circle and is taken away.  From a unit that stays
# a way along units that stay comes back to itself: that is a circle.
function find_circle(   a, i, keep, more, way, at) {
  do {
    more = 0
    for (a in units) {
      keep = 0
      for (i = 1; i <= n_next[a]; i++)
        if (next_of[a, i] in units)
          keep = 1
      if (!keep) {
        delete units[a]
        more = 1
      }
    }
  } while (more)
  for (a in units)
    break
  if (!(a in units))
    return
  while (!(a in at)) {
    at[a] = ++more
    way[more] = a
    for (i = 1; !(next_of[a, i] in units); i++)
      ;
    a = next_of[a, i]
  }
  message = "circle: "
  for (i = at[a]; i <= more; i++)
    message = message substr(way[i], 5) " -> "
  offend("circle", message substr(a, 5))
}
' $(find src -name '*.[ch]' | LC_ALL=C sort)
