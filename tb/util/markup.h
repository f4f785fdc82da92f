// Text in HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace cosim {

/// The text as it stands between tags or in an attribute; what is no character there becomes "?".
inline std::string markup(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += (static_cast<unsigned char>(c) < ' ' && c != '\n') || c == '\x7f' ? '?' : c;
    }
  }
  return safe;
}

}  // namespace cosim
