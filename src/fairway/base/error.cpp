// SPDX-License-Identifier: Apache-2.0
#include "fairway/base/error.hpp"

#include "fairway/base/utf8_text.hpp"

namespace fairway {

tl::unexpected<Error> fail(std::string_view message) {
  return tl::unexpected<Error>(Error{one_line(message)});
}

}  // namespace fairway
