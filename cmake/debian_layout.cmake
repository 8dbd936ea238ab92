# cpack runs this between installing and packing, to meet Debian's special requirements.
# CPACK_TEMPORARY_DIRECTORY has a folder for each component. Times are those of SOURCE_DATE_EPOCH,
# if it is set.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})

# compressed(FILE...): replaces each file by FILE.gz, which contains no name and no time.
function(compressed)
    execute_process(COMMAND gzip -9nf ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ ${CMAKE_CURRENT_LIST_DIR}/../LICENSE licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}")   # heading and holders are told apart
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" licence " ${licence}")
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../LICENSE holders REGEX "^Copyright")
string(REPLACE "Copyright (c) " "" holders "${holders}")

foreach(component package IN ZIP_LISTS CPACK_COMPONENTS_ALL CPACK_DEBIAN_PACKAGE_NAMES)
    set(documents ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/doc/${package})
    file(WRITE ${documents}/copyright
        "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
        "Upstream-Name: Lancer\n\nFiles: *\nCopyright: ${holders}\nLicense: MIT\n${licence}")
    file(WRITE ${documents}/changelog.Debian
        "lancer (${version}) unstable; urgency=medium\n\n"
        "  * What is new stands in /usr/share/doc/lancer/changelog.gz.\n\n"
        " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
    compressed(${documents}/changelog.Debian)
    file(WRITE ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr/share/lintian/overrides/${package}
        "# Not uploaded to Debian.\n${package}: initial-upload-closes-no-bugs *\n")
endforeach()

set(share ${CPACK_TEMPORARY_DIRECTORY}/lancer/usr/share)
file(REMOVE ${share}/doc/lancer/LICENSE)
file(RENAME ${share}/doc/lancer/CHANGELOG.md ${share}/doc/lancer/changelog)
file(RENAME ${share}/zsh/site-functions ${share}/zsh/vendor-completions)
file(GLOB manuals ${share}/man/man1/*.1)
compressed(${share}/doc/lancer/changelog ${manuals})

# The dependencies of the packages. cpack's own method examines each file, which takes ten seconds.
# depends(VARIABLE FILE): the packages whose libraries the FILE needs.
function(depends variable file)
    set(scratch ${CPACK_TEMPORARY_DIRECTORY}/shlibdeps)
    file(WRITE ${scratch}/debian/control "Source: lancer\n")
    execute_process(COMMAND dpkg-shlibdeps -O ${file} WORKING_DIRECTORY ${scratch} COMMAND_ERROR_IS_FATAL ANY
        OUTPUT_VARIABLE line ERROR_VARIABLE ignored OUTPUT_STRIP_TRAILING_WHITESPACE)
    file(REMOVE_RECURSE ${scratch})
    string(REPLACE "shlibs:Depends=" "" line "${line}")
    set(${variable} "${line}" PARENT_SCOPE)
endfunction()
depends(CPACK_DEBIAN_LANCER_PACKAGE_DEPENDS ${CPACK_TEMPORARY_DIRECTORY}/lancer/usr/bin/lancer)
file(GLOB_RECURSE module ${CPACK_TEMPORARY_DIRECTORY}/pictures/usr/lancer_images.so)
depends(CPACK_DEBIAN_PICTURES_PACKAGE_DEPENDS ${module})
string(PREPEND CPACK_DEBIAN_PICTURES_PACKAGE_DEPENDS "lancer (= ${version}), ")
