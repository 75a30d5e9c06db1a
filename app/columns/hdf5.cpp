#include "app/columns/hdf5.hpp"

#include <cerrno>

namespace cognate::app {
namespace {

herr_t keep_description(unsigned /*n*/, const H5E_error2_t* error, void* text) {
  auto& kept = *static_cast<std::string*>(text);
  if (error->desc != nullptr && kept.empty()) kept = error->desc;
  return 0;
}

}  // namespace

void begin_hdf5() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  errno = 0;
}

void throw_hdf5_error() {
  const int system = errno;
  std::string what;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_description, &what);
  throw Hdf5Error(what, system);
}

Handle word_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type, bytes));
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

Handle line_of(hsize_t length) {
  return {H5Screate_simple(1, &length, nullptr), H5Sclose};
}

Handle unlocked_access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  checked(H5Pset_file_locking(access, false, true));
  return access;
}

}  // namespace cognate::app
