#pragma once

#include "converters/format.h"

namespace convert {

// Formats that are read by Assimp. A scene keeps the axes and the units of its file.

/// The format 3D Studio (3DS).
Format three_ds_format();

/// The format stereolithography (STL), in text and binary.
Format stl_format();

/// The format AutoCAD drawing interchange (DXF), in text.
Format dxf_format();

/// The format COLLADA, including its zip archives.
Format collada_format();

/// The format Autodesk FBX, in text and binary.
Format fbx_format();

/// The format LightWave object (LWO), of all versions, and Modo's.
Format lwo_format();

/// The format AC3D.
Format ac3d_format();

/// The format DirectX model (X), in text, binary and compressed.
Format x_format();

/// All other formats with surfaces. Assimp detects the format by content and name, and reads files beside it
/// that it names.
Format other_assimp_format();

}  // namespace convert
