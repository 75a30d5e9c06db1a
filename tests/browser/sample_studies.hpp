/// @file Studies with their rows, for the tests of their page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/study/rows.hpp"
#include "problems/study/study.hpp"

struct SampleStudy {
  std::string name;
  cognate::problems::Study study;
  cognate::app::StudyRows rows;
  nlohmann::ordered_json document;
};

/// A grid of crank-rockers with two objectives; five thousand sampled four-bars in twelve columns;
/// an atlas of coupler curves; a path problem of which some designs failed, stopped early, with
/// text that tries to be markup; a study that kept no row.
std::vector<SampleStudy> sample_studies();

/// Random four-bars, some near a change point, and where the analysis kernel puts their points:
/// [{linkage, angles, points: [[bx, by, cx, cy, px, py] or null]}], angles from the x axis.
nlohmann::ordered_json sample_poses();
