// Holds what legacygl drew (folder ORACLE_EMULATED) against what the system's OpenGL drew
// (ORACLE_REFERENCE): the same bytes, or no channel off by more than 2 of 255, or the counted exception that
// stands beside the scene, for the version of Mesa that the reference ran on. One test a scene.

#include "picture_difference.h"
#include "scene.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace {

std::string read(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path << " was not drawn.";
    return {std::istreambuf_iterator<char>(file), {}};
}

bool shows_something(const std::string& rgba)
{
    for (std::size_t i = 4; i < rgba.size(); ++i) {
        if (rgba[i] != rgba[i % 4]) {
            return true;
        }
    }
    return false;
}

/// Returns whether two texts are the same but for whole numbers that are off by at most `tolerance`.
bool same_but_for(int tolerance, const std::string& a, const std::string& b)
{
    std::istringstream words(a), other_words(b);
    std::string word, other;
    while (words >> word) {
        if (!(other_words >> other)) {
            return false;
        }
        char* end = nullptr;
        const long difference = std::strtol(word.c_str(), &end, 10) - std::strtol(other.c_str(), nullptr, 10);
        if (word != other && (*end != '\0' || std::labs(difference) > tolerance)) {
            return false;
        }
    }
    return !(other_words >> other);
}

class SceneTest : public testing::Test
{
public:
    explicit SceneTest(const oracle::Scene& scene) : scene_(scene) {}

    void TestBody() override
    {
        const std::string emulated = read(ORACLE_EMULATED "/" + scene_.name + ".rgba");
        const std::string reference = read(ORACLE_REFERENCE "/" + scene_.name + ".rgba");
        ASSERT_EQ(emulated.size(), reference.size());
        const std::string told = read(ORACLE_REFERENCE "/" + scene_.name + ".txt");
        EXPECT_TRUE(shows_something(reference) || !told.empty())
            << "The scene is empty and can hold nothing.";
        const oracle::PictureDifference difference = oracle::difference(emulated, reference);
        RecordProperty("pixels_off", difference.pixels);
        RecordProperty("greatest", difference.greatest);
        if (difference.pixels != 0) {
            std::printf("%s: %d pixels differ, %d by more than 2, by %d at most\n", scene_.name.c_str(),
                        difference.pixels, difference.visible, difference.greatest);
        }
        static const int version = oracle::mesa_version(read(ORACLE_REFERENCE "/version"));
        const bool excepted = (scene_.exception.pixels != 0 || scene_.exception.told != 0) &&
                              scene_.exception.versions.contain(version);
        EXPECT_LE(difference.visible, excepted ? scene_.exception.pixels : 0) << scene_.exception.why;
        const std::string emulated_told = read(ORACLE_EMULATED "/" + scene_.name + ".txt");
        if (excepted) {
            EXPECT_TRUE(difference.visible > 0 || emulated_told != told)
                << "The exception is not needed any more: remove it.";
            EXPECT_TRUE(same_but_for(scene_.exception.told, emulated_told, told))
                << emulated_told << "\nis not\n"
                << told;
        } else {
            EXPECT_EQ(emulated_told, told);
        }
    }

private:
    const oracle::Scene& scene_;
};

} // namespace

void oracle::tell(const std::string&) {}
unsigned oracle::next_error()
{
    return 0;
}

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    for (const oracle::Scene& scene : oracle::scenes()) {
        testing::RegisterTest("Oracle", scene.name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [&scene]() -> testing::Test* { return new SceneTest(scene); });
    }
    return RUN_ALL_TESTS();
}
