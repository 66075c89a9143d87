#pragma once

#include <map>
#include <string>

namespace convert {

/// The models that give an error, and how its text begins. With none of the models of Debian 12 does its
/// Assimp 5.2.5 crash or hang.
const std::map<std::string, std::string>& expected_errors();

}  // namespace convert
