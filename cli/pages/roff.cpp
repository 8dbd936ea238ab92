#include "cli/pages/roff.h"

namespace lancer::cli {

std::string roff(std::string_view text) {
    std::string result;
    // roff would read a line that begins with one of these as a request.
    if (text.starts_with('.') || text.starts_with('\'')) result = "\\&";
    bool bold = false;
    for (const char c : text) {
        switch (c) {
            case '\\':
                result += "\\e";
                break;
            case '-':
                result += "\\-";
                break;
            case '\'':
                result += "\\(aq";
                break;
            case '^':
                result += "\\(ha";
                break;
            case '~':
                result += "\\(ti";
                break;
            case '`':
                bold = !bold;
                result += bold ? "\\fB" : "\\fR";
                break;
            default:
                result += c;
        }
    }
    return result;
}

}  // namespace lancer::cli
