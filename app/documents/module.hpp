/// @file Modules that the program loads when they are needed: their libraries take longer to load
/// than most commands to run, and the build leaves them out where those are missing.
#pragma once

namespace cognate::app {

/// The function `name` of the module in the file `module`, which lies where the build or the
/// installation puts it; null where it is in neither place.
void* module_function(const char* module, const char* name);

}  // namespace cognate::app
