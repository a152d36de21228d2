#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
#
# root.sh - what git has at the root of the project is this and nothing else; skipped where there is no clone.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/needs.sh
needs git git
git rev-parse --git-dir >/dev/null 2>&1 || { echo 'skipped: not a clone'; exit 77; }

usual=".ci .clang-format .clang-tidy .gitattributes .gitignore CHANGES.md CMakeLists.txt CMakePresets.json LICENSE
README.md data doc include packages src tests web"
passed=0
failed=0
for entry in $(git ls-files --cached | cut -d/ -f1 | sort -u); do
  case " $(echo $usual) " in
  *" $entry "*) passed=$((passed + 1)) ;;
  *)
    echo "$entry does not belong at the root of the project"
    failed=$((failed + 1))
    ;;
  esac
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 10 ]
