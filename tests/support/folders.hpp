/// @file Folders of the checkout that tests read. Defined in one source, so that no other is
/// compiled anew in another checkout.
#pragma once

namespace cognate {

/// The worked problems, problems/library.
extern const char* const kLibraryFolder;

/// Published values, tests/oracle.
extern const char* const kOracleFolder;

}  // namespace cognate
