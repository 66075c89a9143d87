#pragma once

#include "converters/format.h"

namespace convert {

// Formats that are read through Assimp. A scene has the axes and the units of its file.

/// 3D Studio.
Format three_ds_format();

/// Stereolithography, in text and binary.
Format stl_format();

/// AutoCAD's drawing interchange format, in text.
Format dxf_format();

/// COLLADA, with its zip archives.
Format collada_format();

/// Autodesk FBX, in text and binary.
Format fbx_format();

/// LightWave objects of all versions, and those of Modo.
Format lwo_format();

/// AC3D.
Format ac3d_format();

/// DirectX models, in text, binary and compressed.
Format x_format();

/// All others that make surfaces. Assimp decides by content and name which it is, and reads files beside it
/// that it names.
Format other_assimp_format();

}  // namespace convert
