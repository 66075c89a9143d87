#include "grf/model.h"

#include "grf/keywords.h"

namespace grf {

bool operator==(const Argument& a, const Argument& b) {
  return same_keyword(a.name, b.name) && a.value == b.value;
}

bool operator==(const Model& a, const Model& b) {
  return same_keyword(a.keyword, b.keyword) && a.arguments == b.arguments;
}

}  // namespace grf
