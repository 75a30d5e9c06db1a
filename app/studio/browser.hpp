/// @file The user's browser.
#pragma once

#include <string>

namespace cognate::app {

/// Has the desktop open `address`, if there is one; nothing is said where that fails.
void open_in_browser(const std::string& address);

}  // namespace cognate::app
