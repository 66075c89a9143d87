#pragma once

namespace convert {

/// Runs `grfconvert formats`: prints the table of formats.
void print_formats(bool json);

}  // namespace convert
