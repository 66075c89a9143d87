// Property tests use the same random values in every run. The environment variable RC_PARAMS, such as
// `RC_PARAMS="seed=1 max_success=10000"`, overrides this.
#include <stdlib.h>

namespace {

[[maybe_unused]] const int Seeded = setenv("RC_PARAMS", "seed=20080131 max_success=1000", 0);

}  // namespace
