#include "judge/validate/place_words.h"

#include <fmt/format.h>

namespace lancer::judge {

namespace {

std::string at_place(const ValidationJob& job, const SourceSpan& span) {
    const std::string place = job.place_text ? job.place_text(span) : "";
    return place.empty() ? "" : " at " + place;
}

}  // namespace

std::string object_words(const ValidationJob& job, std::size_t index) {
    const Object& shown = job.scene->objects[index];
    const std::string name =
        shown.name == none ? "" : fmt::format(" \"{}\"", job.scene->names[shown.name]);
    return fmt::format("object {}{}{}", index + 1, name, at_place(job, shown.place));
}

std::string light_words(const ValidationJob& job, std::size_t index) {
    return fmt::format("light {}{}", index + 1, at_place(job, job.scene->lights[index].place));
}

}  // namespace lancer::judge
