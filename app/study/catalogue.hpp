/// @file What a study file may say, as data: for `cognate list` and the documents.
#pragma once

#include <span>

#include "app/documents/catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"

namespace cognate::app {

/// The keys of a study, table by table.
std::span<const KeyedEntry> study_tables();

/// The values of `vary.sampling`.
std::span<const Entry> samplings();

}  // namespace cognate::app
