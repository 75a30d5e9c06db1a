/// @file Cams: motion laws, profiles, and the search for dimensions.
#pragma once

#include "analysis/cam/cam.hpp"
#include "analysis/cam/follower.hpp"
#include "analysis/cam/motion_law.hpp"
#include "analysis/cam/motion_programme.hpp"
#include "analysis/cam/profile.hpp"
#include "problems/cam/problem.hpp"
#include "problems/cam/result.hpp"
