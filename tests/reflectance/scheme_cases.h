#pragma once

#include <string>

#include "renderer/reflectance/scheme.h"

namespace test {

/// The sampling scheme that a text such as `hemisphere exp=20` describes, without its tables.
reflectance::Scheme scheme_of(const std::string& text);

}  // namespace test
