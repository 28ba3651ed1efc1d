#pragma once

#include <string>
#include <string_view>

namespace toile {

// SHA-256 (FIPS 180-4) of the bytes: 64 hexadecimal digits, lower case, as sha256sum prints them.
std::string sha256(std::string_view bytes);

}  // namespace toile
