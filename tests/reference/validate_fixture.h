// Whole validations: our tracer, the exporter and POV-Ray.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/our_renderer.h"
#include "model/io/temporary_file.h"
#include "reference/validate/validate.h"
#include "tests/reference/pov/povray_fixture.h"

namespace lancer::reference {

using Fault = std::function<void(Scene&)>;

class Validate : public WithPovRay {
  protected:
    /// `fault` is done to our scene alone; not to what the judge's own recursion sees of it, where
    /// the fault shall be one of our recursion. POV-Ray's picture is made once and kept.
    Validation validate(const Scene& scene, const Fault& fault = {},
                        const Expectations& expect = {}, bool of_recursion = false) {
        ValidationJob job;
        job.name = "test";
        job.scene = std::make_shared<const Scene>(scene);
        job.view = {0, 160, 120};
        job.expect = expect;
        const OurRenderer renderer = [&](const Scene& given, const ExportView& view) {
            Scene ours = given;
            if (fault) fault(ours);
            OurPicture picture = cli::render_ours(ours, view);
            if (of_recursion) picture.by_rules = cli::render_ours(given, view).by_rules;
            return picture;
        };
        PovOptions options;
        options.cache = cache().path().string();
        return validate_scene(job, renderer, find_povray(), options);
    }

    void expect_caught(const Scene& scene, const Fault& fault, std::size_t least_unexplained) {
        const Validation v = validate(scene, fault);
        EXPECT_EQ(v.verdict, Verdict::differs);
        EXPECT_GE(v.judgement.count(PixelClass::unexplained), least_unexplained);
    }

    static io::TemporaryFolder& cache() {
        static io::TemporaryFolder folder;
        return folder;
    }
};

inline std::string said(const Validation& v) {
    std::string text = v.name + "\n";
    for (const std::string& reason : v.reasons) text += reason + "\n";
    return text;
}

}  // namespace lancer::reference
