// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace fairway::io {

/// Initialises GraphicsMagick; call this before its other functions. Its signal handlers stay off,
/// because a library must not install any.
void initialize_graphics_magick();

}  // namespace fairway::io
