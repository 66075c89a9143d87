#pragma once

#include <map>
#include <set>
#include <string>

namespace convert {

/// The models that give an error, and how its text begins.
const std::map<std::string, std::string>& expected_errors();

/// The models with which Assimp crashes or does not end.
const std::set<std::string>& crashing_models();

}  // namespace convert
