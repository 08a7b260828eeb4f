# Sourced by the scripts beside it: where things are, and how to say something.
# shellcheck shell=bash

# shellcheck disable=SC2034  # for those who source this
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() {
    printf '%s\n' "$*" >&2
}

# Something the user has to settle: a missing tool, a wrong argument.
stop() {
    printf '%s: %s\n' "${0##*/}" "$*" >&2
    exit 2
}

# Prints the sha256 of what stands on standard input.
digest() {
    sha256sum | cut -c1-64
}

cores() {
    nproc 2>/dev/null || echo 2
}

# emcc of Debian needs its own acorn from -O2 on, which a Node.js of another origin does not find.
use_debian_acorn() {
    if [[ -d /usr/share/nodejs/acorn && :${NODE_PATH-}: != *:/usr/share/nodejs:* ]]; then
        export NODE_PATH=${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs
    fi
}
