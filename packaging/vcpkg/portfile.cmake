# Not yet run.
vcpkg_download_distfile(
  archive
  URLS "@ARCHIVE@"
  FILENAME "pw85-${VERSION}.tar.gz"
  SHA512 @ARCHIVE_SHA512@
)
vcpkg_extract_source_archive(source ARCHIVE "${archive}")
vcpkg_configure_meson(
  SOURCE_PATH "${source}"
  OPTIONS
    -Dgsl=disabled
    -Dgpu=disabled
    -Dtests=disabled
    -Dbench=disabled
    -Dpython=disabled
    -Dfortran=disabled
)
vcpkg_install_meson()
vcpkg_fixup_pkgconfig()
vcpkg_cmake_config_fixup(PACKAGE_NAME pw85_gpu CONFIG_PATH lib/cmake/pw85_gpu DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME pw85_legacy CONFIG_PATH lib/cmake/pw85_legacy DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME pw85 CONFIG_PATH lib/cmake/pw85)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
