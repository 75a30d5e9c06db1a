/// @file Many positions, or many designs, at once on vector instructions: cognate::analysis.
#pragma once

#include "analysis/batch/chain_batch.hpp"
#include "analysis/batch/crank_table.hpp"
#include "analysis/batch/four_bar_batch.hpp"
#include "analysis/batch/instruction_set.hpp"
