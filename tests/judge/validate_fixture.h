// Whole validations: our tracer, the exporter and POV-Ray.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "judge/validate/our_renderer.h"
#include "judge/validate/validate.h"
#include "model/io/temporary_file.h"
#include "tests/reference/pov/povray_fixture.h"

namespace lancer::judge {

using namespace reference;  // its scenes and its runner

using Fault = std::function<void(Scene&)>;

class Validate : public reference::WithPovRay {
  protected:
    /// `fault` changes only our scene. With `of_recursion`, the judge's own recursion gets the
    /// unchanged scene, as if only our renderer's recursion had the error. POV-Ray's picture is
    /// made once and kept.
    Validation validate(const Scene& scene, const Fault& fault = {},
                        const Expectations& expect = {}, bool of_recursion = false) {
        ValidationJob job;
        job.name = "test";
        job.scene = std::make_shared<const Scene>(scene);
        job.view = view_;
        job.expect = expect;
        const OurRenderer renderer = [&](const std::shared_ptr<const Scene>& given,
                                         const reference::ExportView& view) {
            if (!fault) return render_ours(given, view);
            const auto ours = std::make_shared<Scene>(*given);
            fault(*ours);
            OurPicture picture = render_ours(ours, view);
            if (of_recursion) picture.by_rules = render_ours(given, view).by_rules;
            return picture;
        };
        reference::PovOptions options;
        options.cache = cache().path().string();
        return validate_scene(job, renderer, reference::find_povray(), options);
    }

    void expect_caught(const Scene& scene, const Fault& fault, std::size_t least_unexplained) {
        const Validation v = validate(scene, fault);
        EXPECT_EQ(v.verdict, Verdict::differs);
        EXPECT_GE(v.judgement.count(PixelClass::unexplained), least_unexplained);
    }

    reference::ExportView view_{0, 160, 120};

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

}  // namespace lancer::judge
