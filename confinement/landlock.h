// Landlock confines the files of a process (https://docs.kernel.org/userspace-api/landlock.html).
#pragma once

#include "confinement/confinement.h"

namespace confinement {

/// Returns the version of the kernel's interface; 0 if it has none.
int landlock_version();

/// Confines files. Returns the version, or 0 if the kernel refuses.
int confine_files(const Policy& policy);

}  // namespace confinement
