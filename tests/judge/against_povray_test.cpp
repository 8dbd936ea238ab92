// POV-Ray's own pictures, judged as files: in every scene of the collection, pixels have the same
// classes as in a validation, except for classes that need POV-Ray itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

#include "base/parallel.h"
#include "judge/against/against.h"
#include "tests/judge/validate_fixture.h"
#include "tests/scenes/every_scene.h"

namespace lancer::judge {
namespace {

constexpr int width = 64;

struct BothWays {
    std::string path;
    Validation asked;    ///< POV-Ray was there
    Validation as_file;  ///< only its picture was
};

class AgainstPovRay : public Validate {
  protected:
    /// Every scene that POV-Ray can be asked about, both ways.
    std::vector<BothWays> every_scene() {
        std::vector<ValidationJob> jobs;
        for_each_scene([&](Scene& scene, const std::string& path) {
            prepare_for_validation(scene);
            ValidationJob job;
            job.name = std::filesystem::path(path).stem().string();
            job.path = path;
            job.view = {0, width, std::max(1, width * scene.height / scene.width)};
            job.expect = read_expectations(path);
            if (job.expect.refused) return;
            job.scene = std::make_shared<const Scene>(std::move(scene));
            jobs.push_back(std::move(job));
        });
        std::vector<BothWays> results(jobs.size());
        const auto workers =
            static_cast<int>(2 * std::max(1U, std::thread::hardware_concurrency()));
        for_each_task(static_cast<int>(jobs.size()), workers, {}, [&](const NextTask& next) {
            for (int task = 0; next(task);) {
                const auto i = static_cast<std::size_t>(task);
                results[i] = both_ways(jobs[i], std::to_string(task));
            }
        });
        return results;
    }

    BothWays both_ways(const ValidationJob& job, const std::string& name) {
        reference::PovOptions options;
        options.cache = reference::cache_folder();
        BothWays both{job.path, validate_scene(job, render_ours, povray_, options), {}};
        AgainstJob against;
        against.scene = job;
        against.size_is_given = true;
        against.reading.exposure = both.asked.exposure;
        against.picture = (cache().path() / (name + ".png")).string();
        io::ImageWriteOptions as_it_is;
        as_it_is.bits = 16;
        as_it_is.linear = true;
        io::write_image(against.picture, both.asked.theirs, as_it_is);
        both.as_file = validate_against(against);
        return both;
    }
};

TEST_F(AgainstPovRay, EveryPixelOfEverySceneHasTheSameClass) {
    const std::vector<BothWays> scenes = every_scene();
    EXPECT_GE(scenes.size(), 100U);
    std::size_t pixels = 0;
    std::size_t different = 0;
    std::size_t undecidable = 0;
    for (const BothWays& both : scenes) {
        const std::vector<PixelClass>& asked = both.asked.judgement.classes;
        const std::vector<PixelClass>& as_file = both.as_file.judgement.classes;
        ASSERT_FALSE(asked.empty()) << both.path << said(both.asked);
        ASSERT_EQ(asked.size(), as_file.size()) << both.path << said(both.as_file);
        pixels += asked.size();
        std::set<std::size_t> took_povray;
        for (const DifferentPixel& p : both.asked.judgement.different)
            if (p.took_povray) took_povray.insert(static_cast<std::size_t>(p.y * width + p.x));
        for (std::size_t i = 0; i < asked.size(); ++i) {
            different += asked[i] == PixelClass::agrees ? 0 : 1;
            // A scene with coincident faces may have these differences anywhere; others are rare.
            if (asked[i] == PixelClass::coincident)
                EXPECT_FALSE(both.asked.coincidences.empty()) << both.path;
            else
                undecidable += needs_povray(asked[i]) ? 1 : 0;
            if (needs_povray(asked[i]) || took_povray.contains(i)) continue;
            EXPECT_EQ(class_name(as_file[i]), class_name(asked[i]))
                << both.path << " (" << i % width << ", " << i / width << ")";
        }
    }
    EXPECT_GT(pixels, 300'000U);
    EXPECT_GT(different, 100U);
    EXPECT_LT(undecidable, pixels / 1000);
}

}  // namespace
}  // namespace lancer::judge
