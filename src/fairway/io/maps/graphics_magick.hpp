// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::io {

/// To be called before anything of GraphicsMagick's. Without its signal handlers: a library has no
/// business there.
void initialize_graphics_magick();

}  // namespace fairway::io
