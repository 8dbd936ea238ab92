# Headers that most sources read, read once: half of a build's time is reading them. Only the presets
# `clang` and `asan` ask for it (LANCER_PRECOMPILE); gcc's build reads every source as it is written, and
# so finds the one that forgets to include what it uses. Gcc would gain little: 0.5 s a source with fmt's headers, and it
# loses 7 s with those of the command line's library, whose functions it then looks at in every source.
option(LANCER_PRECOMPILE "Read common headers once" OFF)

set(lancer_common_headers
    <algorithm> <array> <bit> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory>
    <optional> <random> <set> <string> <string_view> <utility> <variant> <vector>
    <fmt/format.h> ${PROJECT_SOURCE_DIR}/model/scene.h ${PROJECT_SOURCE_DIR}/model/diagnostic.h)

# lancer_share_headers(HOST HEADERS...): makes ready what lancer_precompile(TARGET HOST) uses. The compiler wants
# the same options at both places, so a host serves the targets of its kind and folder.
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
