# What every program that a page of ours loads is linked with, and where what differs between versions of Emscripten
# is settled. From 3.1.6 to 6.0 that is little, since no setting that we use was taken away:
# - Views of the memory are exported only where they are listed. Up to 3.1 they came unasked, and listing does no harm.
#   A view is the newest one as long as it is read from the module, which growing memory renews.
# - Callbacks return EM_BOOL, which was int and is bool.
# - The stack has become small: the toolchain file beside this one gives every program a large one.
# - Some come without compiled system libraries: use_emscripten in scripts/common.sh sees to their cache.

set(tanklab_webgl2 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)

# Makes the target a module: a factory that takes what Emscripten describes, and gives the functions of Emscripten's
# and views of the memory that are named after the target.
function(tanklab_web_module target)
  list(JOIN ARGN "," methods)
  target_link_options(${target} PRIVATE
    -sMODULARIZE -sENVIRONMENT=web
    -sALLOW_MEMORY_GROWTH               # a user's own tank may be any size
    -sEXPORTED_RUNTIME_METHODS=${methods})
endfunction()
