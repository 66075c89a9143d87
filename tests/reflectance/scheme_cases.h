#pragma once

#include <string>

#include "renderer/reflectance/scheme.h"

namespace test {

/// Makes the sampling scheme of a text such as `hemisphere exp=20`, without its tables.
reflectance::Scheme scheme_of(const std::string& text);

}  // namespace test
