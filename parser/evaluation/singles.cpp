#include "parser/evaluation/singles.h"

namespace lancer {

/// Adds a note with the place of the first one.
static void point_to(const SourceSpan& first, Diagnostic* error) {
    if (error != nullptr)
        error->notes.insert(error->notes.begin(), Report::note(Message::first_here, first));
}

bool is_repeated(std::string_view word, SourceSpan& first, const SourceSpan& place,
                 Report& report) {
    if (first.file == SourceSpan::nowhere) {
        first = place;
        return false;
    }
    point_to(first, report.error(Message::given_twice, place, word));
    return true;
}

bool Singles::is_second_background(const SourceSpan& place) {
    if (is_second("background", background_, place)) return true;
    refuse_beside(sky_, place);
    return false;
}

bool Singles::is_second_sky(const SourceSpan& place) {
    if (is_second("sky", sky_, place)) return true;
    refuse_beside(background_, place);
    return false;
}

void Singles::refuse_beside(const SourceSpan& other, const SourceSpan& place) {
    if (other.file == SourceSpan::nowhere) return;
    point_to(other, report_.error(Message::sky_and_background, place));
}

bool Singles::is_new_camera(const std::string& name, const SourceSpan& place) {
    if (name.empty()) return true;
    const auto [first, is_new] = cameras_.emplace(name, place);
    if (is_new) return true;
    point_to(first->second, report_.error(Message::camera_twice, place, name));
    return false;
}

}  // namespace lancer
