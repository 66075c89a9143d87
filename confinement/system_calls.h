// A seccomp filter confines the system calls of a process.
#pragma once

namespace confinement {

/// Returns whether the kernel has seccomp filters.
bool has_system_call_filters();

/// Confines system calls to those of a reader. Returns whether the kernel accepted it.
bool confine_system_calls();

}  // namespace confinement
