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

# Lets one script at a time work in this clone: they share build and node_modules. Others wait, and say so.
# The turn ends with this script and the programs that it started: a compiler that outlives a killed script is
# waited for. What might outlive it for long is started with 8>&-.
take_turn() {
    # What a script starts works in that script's turn.
    [[ ${TANKLAB_TURN-} != "$root" ]] || return 0
    { mkdir -p "$root/build" && [[ -w $root/build ]]; } 2>/dev/null ||
        stop "the folder $root/build cannot be written: everything goes there; clone to where you may write"
    exec 8<>"$root/build/turn"
    if ! flock --nonblock 8; then
        say "$(<"$root/build/turn") is at work in this folder; waiting until that is done ..."
        flock 8
    fi
    printf 'scripts/%s (process %s)\n' "${0##*/}" "$$" >"$root/build/turn"
    export TANKLAB_TURN=$root
    use_writable_home
}

# npm, emcc and the browsers keep things at home, and fail in their own ways where that cannot be written.
use_writable_home() {
    [[ ! -w ${HOME-} ]] || return 0
    say "(The home folder '${HOME-}' cannot be written; build/home takes its place.)"
    export npm_config_userconfig=${npm_config_userconfig-${HOME-}/.npmrc} HOME=$root/build/home
    mkdir -p "$HOME"
}

# Prints the sha256 of what stands on standard input.
digest() {
    sha256sum | cut -c1-64
}

cores() {
    nproc 2>/dev/null || echo 2
}

# Lets emcc find what it needs besides itself; scripts/cmake/emscripten.cmake hands it on to the build.
use_emscripten() {
    local cache
    # That of Debian needs its own acorn from -O2 on, which a Node.js of another origin does not find.
    if [[ -d /usr/share/nodejs/acorn && :${NODE_PATH-}: != *:/usr/share/nodejs:* ]]; then
        export NODE_PATH=${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs
    fi
    # One that comes without its system libraries compiles them into its cache, which has to be writable for that.
    if [[ -z ${EM_CACHE-} && $(em-config FROZEN_CACHE 2>/dev/null) != True ]]; then
        cache=$(em-config CACHE 2>/dev/null) || return 0
        mkdir -p "$cache" 2>/dev/null || true
        [[ -w $cache ]] || export EM_CACHE=$root/build/deps/emscripten-cache
    fi
}

# Configures a preset where that is due, and builds it.
#   build_preset PRESET FOLDER [-DOPTION=VALUE ...] [arguments of cmake --build]
build_preset() {
    take_turn
    local preset=$1 folder=$root/build/$2 log option options=() due=no
    shift 2
    use_emscripten
    [[ -f $folder/build.ninja && ! $root/CMakePresets.json -nt $folder/CMakeCache.txt ]] || due=yes
    while [[ ${1-} == -D* ]]; do
        option=${1#-D}
        grep -qxE "${option%%=*}:[A-Z]+=${option#*=}" "$folder/CMakeCache.txt" 2>/dev/null || due=yes
        options+=("$1")
        shift
    done
    if [[ $due == yes ]]; then
        say "Configuring $preset ..."
        log=$root/build/configure-$preset.log
        (cd "$root" && cmake --preset "$preset" "${options[@]}") >"$log" 2>&1 </dev/null || { cat "$log" >&2 && return 1; }
    fi
    say "Building $preset ..."
    # Ninja's progress goes by line where it is no terminal: only what went wrong is of interest then.
    (cd "$root" && NINJA_STATUS='[%f/%t] ' cmake --build "$folder" "$@") </dev/null
}
