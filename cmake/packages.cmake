# `cpack -G DEB` in a build folder: lancer, and lancer-pictures with what needs OpenImageIO.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lancer)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Lancer authors <maintainers@users.noreply.h-seed-deef0dde.example>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
# Independent of the umask of the user who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_COMPONENTS_ALL lancer pictures)
set(CPACK_DEBIAN_PACKAGE_NAMES lancer lancer-pictures)   # in the same order; for debian_layout.cmake
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)   # xz takes eight times as long, for a fifth of the size

set(CPACK_DEBIAN_LANCER_PACKAGE_NAME lancer)
set(CPACK_DEBIAN_LANCER_PACKAGE_RECOMMENDS lancer-pictures)
set(CPACK_DEBIAN_LANCER_PACKAGE_SUGGESTS "povray, bash-completion")
set(CPACK_COMPONENT_LANCER_DESCRIPTION
"ray tracer with a small scene language, judged against POV-Ray
Lancer renders scenes that are written as text to pictures. It exports
them to POV-Ray, too, has POV-Ray render them, and explains each pixel
that differs. Pictures do not depend on the scale of a scene, on the
number of threads or on the processor.
.
This package reads and writes PNG and PPM. For EXR, Radiance, TIFF and
JPEG it takes the package lancer-pictures.")

set(CPACK_DEBIAN_PICTURES_PACKAGE_NAME lancer-pictures)
set(CPACK_COMPONENT_PICTURES_DESCRIPTION
"EXR, Radiance, TIFF and JPEG for the ray tracer Lancer
Lancer renders scenes that are written as text to pictures. This package
has it read and write pictures other than PNG and PPM, by OpenImageIO,
libtiff and libjpeg, which run in a process of their own.")

# This script also determines the dependencies of the packages.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_layout.cmake)
include(CPack)
