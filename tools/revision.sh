#!/bin/sh
# The revision of this checkout; nothing where there is none, as in an archive that was unpacked inside another repository.
unset GIT_DIR GIT_WORK_TREE
inside=$(git rev-parse --show-prefix 2>/dev/null) && [ -z "$inside" ] || exit 0
git ls-files --error-unmatch codemeta.json >/dev/null 2>&1 || exit 0
git describe --always --dirty --abbrev=12 2>/dev/null
