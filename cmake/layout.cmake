# Where the parts of an installation stand; the build folder is laid out in the same way, with links to the sources
# where a program looks for data. base/installation.h finds them.
include(GNUInstallDirs)
set(SOLITAIRE_DATA_INSTALL_DIR share/solitaire)

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/solitaire)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/assets ${PROJECT_BINARY_DIR}/share/solitaire/assets SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/solitaire/std ${PROJECT_BINARY_DIR}/share/solitaire/std SYMBOLIC)
