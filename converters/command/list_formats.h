#pragma once

namespace convert {

/// `grfconvert formats`: the table of formats.
void print_formats(bool json);

}  // namespace convert
