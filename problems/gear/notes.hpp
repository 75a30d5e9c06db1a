/// @file Why a gear, or a pair, cannot be or cannot run.
#pragma once

#include <string>
#include <vector>

#include "analysis/gear/other_gears.hpp"
#include "problems/gear/result.hpp"

namespace cognate::problems {

/// What makes a gear impossible: a sentence about `name`, "The pinion", for each; none of a sound
/// one.
std::vector<std::string> gear_notes(const gear::HelicalGear& gear, const std::string& name,
                                    bool undercut_is_allowed = false);

/// That the rack cuts into the involute, and the shift that avoids it; empty where it does not.
std::string undercut_note(const gear::SpurGear& section, double needed_shift,
                          const std::string& name);

/// The same of a bevel gear whose virtual gear is `section`: `cosine` is that of its cone.
std::string undercut_note_of_cone(const gear::SpurGear& section, double cosine,
                                  const std::string& name);

/// Adds `more` to `notes`.
inline void append(std::vector<std::string>& notes, const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
}

/// `note`, if any, and where it `is_allowed` that `key` is what allows it.
std::string allowed(const std::string& note, bool is_allowed, const char* key);

/// What makes a transverse section impossible, with the note of its undercut, if any.
std::vector<std::string> section_notes(const gear::SpurGear& section, const std::string& undercut,
                                       const std::string& name);

/// That tips dig into fillets or roots.
std::vector<std::string> interference_notes(const gear::SpurPair& pair,
                                            const gear::PairGeometry& mesh, bool is_allowed);

/// The same of a cylindrical pair and of its mesh.
std::vector<std::string> gear_pair_notes(const GearPairDesign& design);

}  // namespace cognate::problems
