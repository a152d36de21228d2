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
README.md CONTRIBUTING.md SECURITY.md CITATION.cff data doc include packages src tests web"
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
# the examples of CONTRIBUTING.md and the evidence of decisions.md are commits, and the files that it and SECURITY.md name are there
for commit in $(grep -o '`[0-9a-f]\{8\}`' CONTRIBUTING.md doc/decisions.md | sed 's/.*://' | tr -d '`'); do
  git cat-file -e "$commit^{commit}" 2>/dev/null && passed=$((passed + 1)) || { echo "there is no commit $commit" && failed=$((failed + 1)); }
done
for file in $(grep -oh '](\([^)#]*\)' CONTRIBUTING.md SECURITY.md | sed 's/](//') $(grep -o '`\(src\|include\|tests\|doc\)/[^ `*]*`' CONTRIBUTING.md | tr -d '`'); do
  [ -e "$file" ] && passed=$((passed + 1)) || { echo "$file is not there" && failed=$((failed + 1)); }
done
version=$(sed -n 's/.*FOURLINK_VERSION "\(.*\)"/\1/p' include/fourlink.h)
grep -qx "version: $version" CITATION.cff || { echo "CITATION.cff has another version than $version" && failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 10 ]
