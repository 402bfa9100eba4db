# Writes SOURCE, a C++ file with the bytes of PAGE.
file(READ ${PAGE} bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${SOURCE} "#include \"fairway/io/web_report/viewer_page.hpp\"

namespace fairway::io {
namespace {
constexpr unsigned char kPage[] = {
${bytes}};
}  // namespace
std::string_view viewer_page() noexcept {
  return {reinterpret_cast<const char*>(kPage), sizeof kPage};
}
}  // namespace fairway::io
")
