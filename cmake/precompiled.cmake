# Reads common headers once: half of a build's time is spent on reading them. Only the presets
# `clang` and `asan` use this (LANCER_PRECOMPILE). Gcc's build reads every source as it is, and so
# finds sources that forget an include. Gcc would gain little: 0.5 s per source with fmt's headers;
# with those of the command line's library, it loses 7 s, because it then examines their functions
# in every source.
option(LANCER_PRECOMPILE "Read common headers once" OFF)

set(lancer_common_headers
    <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
    <optional> <random> <set> <string> <string_view> <utility> <variant> <vector>
    <fmt/format.h> ${PROJECT_SOURCE_DIR}/model/scene.h ${PROJECT_SOURCE_DIR}/model/diagnostic.h)

# lancer_share_headers(HOST HEADERS...): prepares what lancer_precompile(TARGET HOST) uses. The
# compiler requires the same options in both places, so a host serves the targets of its kind and
# folder.
function(lancer_share_headers host)
    if(LANCER_PRECOMPILE)
        target_link_libraries(${host} PRIVATE lancer_options)
        target_precompile_headers(${host} PRIVATE ${lancer_common_headers} ${ARGN})
    endif()
endfunction()

function(lancer_precompile target host)
    if(LANCER_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${host})
    endif()
endfunction()
