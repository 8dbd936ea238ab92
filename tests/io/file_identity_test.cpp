#include "model/io/file_identity.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/io/scratch_folder.h"

namespace lancer::io {
namespace {

namespace fs = std::filesystem;

class Identity : public testing::Test {
  protected:
    Identity() {
        fs::create_directory(folder_ / "d");
        put(folder_ / "d/file", "x");
        put(folder_ / "d/other", "x");
    }
    std::string key(const std::string& name) const { return identity_of(folder_ / name).key; }
    ScratchFolder folder_;
};

TEST_F(Identity, IsTheSameThroughEveryKindOfName) {
    fs::create_symlink("d", folder_ / "folder_link");
    fs::create_symlink("d/file", folder_ / "link");
    fs::create_symlink("link", folder_ / "link_to_link");
    fs::create_hard_link(folder_ / "d/file", folder_ / "hard");
    for (const char* name :
         {"d/./file", "d/../d/file", "folder_link/file", "link", "link_to_link", "hard"})
        EXPECT_EQ(key(name), key("d/file")) << name;
    EXPECT_NE(key("d/other"), key("d/file"));
    EXPECT_TRUE(identity_of(folder_ / "link").is_ordinary);
}

TEST_F(Identity, AFileThatIsNotThereYetIsKnownByItsPlace) {
    fs::create_symlink("d", folder_ / "folder_link");
    fs::create_symlink("d/new", folder_ / "link");
    for (const char* name : {"d/./new", "d/../d/new", "folder_link/new", "link"})
        EXPECT_EQ(key(name), key("d/new")) << name;
    EXPECT_NE(key("d/newer"), key("d/new"));
    EXPECT_NE(key("new"), key("d/new"));
    EXPECT_EQ(key("no/folder/../file"), key("no/file"));
    fs::create_symlink("round", folder_ / "round");
    EXPECT_NE(key("round"), key("d/new"));
}

TEST_F(Identity, ADescriptorIsTheFileThatItLeadsTo) {
    FILE* file = fopen((folder_ / "d/file").c_str(), "r");
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(identity_of(fileno(file)).key, key("d/file"));
    EXPECT_EQ(identity_of("/dev/fd/" + std::to_string(fileno(file))).key, key("d/file"));
    fclose(file);
    EXPECT_FALSE(identity_of("/dev/null").is_ordinary);
}

}  // namespace
}  // namespace lancer::io
