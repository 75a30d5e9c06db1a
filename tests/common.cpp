// Nothing of its own: what CMake compiles the tests' common headers with.
