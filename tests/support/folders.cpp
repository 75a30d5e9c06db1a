#include "tests/support/folders.hpp"

namespace cognate {

const char* const kLibraryFolder = COGNATE_LIBRARY_DIR;
const char* const kOracleFolder = COGNATE_ORACLE_DIR;

}  // namespace cognate
