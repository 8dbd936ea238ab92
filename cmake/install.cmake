# The files that `cmake --install` installs. Everything is found relative to the program, so that
# the whole can be moved. Two components: `lancer`, and `pictures` with everything that needs
# OpenImageIO.
include(GNUInstallDirs)
set(LANCER_MODULE_DIR ${CMAKE_INSTALL_LIBDIR}/lancer)

# The path from the program to the folder of its picture module. Libraries within an archive are
# there, too (./release).
file(RELATIVE_PATH module_folder /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${LANCER_MODULE_DIR})
set_source_files_properties(${PROJECT_SOURCE_DIR}/model/io/image_module_loader.cpp TARGET_DIRECTORY lancer_io
    PROPERTIES COMPILE_DEFINITIONS LANCER_MODULE_FOLDER="${module_folder}")
set_target_properties(lancer PROPERTIES INSTALL_RPATH "$ORIGIN/${module_folder}")
set_target_properties(lancer_images PROPERTIES INSTALL_RPATH "$ORIGIN")

install(TARGETS lancer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lancer)
install(TARGETS lancer_images LIBRARY DESTINATION ${LANCER_MODULE_DIR} COMPONENT pictures)

set(pages ${PROJECT_BINARY_DIR}/pages)
install(DIRECTORY ${pages}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT lancer)
install(DIRECTORY ${pages}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT lancer)
install(DIRECTORY ${pages}/zsh/ DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT lancer)
install(DIRECTORY ${pages}/fish/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT lancer)
install(DIRECTORY ${pages}/vim/ DESTINATION ${CMAKE_INSTALL_DATADIR}/vim/vimfiles COMPONENT lancer)
install(DIRECTORY ${pages}/vscode DESTINATION ${CMAKE_INSTALL_DATADIR}/lancer COMPONENT lancer)

install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT lancer)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT lancer
    FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT lancer)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT lancer PATTERN bad EXCLUDE)
