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

# Configures a preset where that is due, and builds it.
#   build_preset PRESET FOLDER [arguments of cmake --build]
build_preset() {
    local preset=$1 folder=$root/build/$2 log
    shift 2
    use_debian_acorn
    if [[ ! -f $folder/build.ninja || $root/CMakePresets.json -nt $folder/CMakeCache.txt ]]; then
        say "Configuring $preset ..."
        mkdir -p "$root/build"
        log=$root/build/configure-$preset.log
        (cd "$root" && cmake --preset "$preset") >"$log" 2>&1 </dev/null || { cat "$log" >&2 && return 1; }
    fi
    say "Building $preset ..."
    # Ninja's progress goes by line where it is no terminal: only what went wrong is of interest then.
    (cd "$root" && NINJA_STATUS='[%f/%t] ' cmake --build "$folder" "$@") </dev/null
}
