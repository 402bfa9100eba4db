// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/graphics_magick.hpp"

#include <Magick++.h>

namespace fairway::io {

void initialize_graphics_magick() {
  static const bool done = [] {
    MagickLib::ExceptionInfo exception;
    MagickLib::GetExceptionInfo(&exception);
    const unsigned int ok =
        MagickLib::InitializeMagickEx(nullptr, MAGICK_OPT_NO_SIGNAL_HANDER, &exception);
    MagickLib::DestroyExceptionInfo(&exception);
    return ok != 0;
  }();
  static_cast<void>(done);
}

}  // namespace fairway::io
