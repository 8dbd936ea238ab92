// The comment at the top of the `.pov`. It does not change the picture.
#include <fmt/format.h>

#include "reference/pov/writer.h"

namespace lancer::reference::pov {

namespace {

// Describes how to obtain the scene's samples per pixel; empty for one sample.
std::string samples_note(const Writer& writer) {
    const int n = writer.scene.settings.samples;
    if (n <= 1) return "";
    return fmt::format(
        "// The scene asks for {0} x {0} rays per pixel: render {1} x {2} and average blocks of "
        "{0} x {0}.",
        n, n * writer.view.width, n * writer.view.height);
}

}  // namespace

void write_header(Writer& writer) {
    Text& text = writer.text;
    text.line("// " + comment(writer.options.name) + ": written by Lancer for POV-Ray 3.7");
    text.line(fmt::format(
        "// povray +I{}.pov +W{} +H{} +FN16 File_Gamma=1.0 -D -A   (16 bit, linear light)",
        comment(writer.options.name), writer.view.width, writer.view.height));
    const std::string samples = samples_note(writer);
    if (!samples.empty()) text.line(samples);
    text.line(writer.scale.exponent == 0
                  ? "// Lengths are those of the scene."
                  : "// Lengths are those of the scene times " + number(writer.scale.factor()) +
                        ": POV-Ray sees no hit nearer than 1e-4, no shadow nearer than 1e-3.");
    if (writer.options.exposure != 1)
        text.line("// Lights, emission and background are multiplied by " +
                  number(writer.options.exposure) + ".");
}

}  // namespace lancer::reference::pov
