#include "asset_fixtures.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace assets {

namespace {

constexpr char TRIANGLE[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";

} // namespace

std::string tiny_tga()
{
    // Header: uncompressed true colour, 2 x 2, 24 bits, rows from the bottom.
    std::string bytes = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0};
    for (int i = 0; i < 12; ++i) {
        bytes.push_back(static_cast<char>(20 * i));
    }
    return bytes;
}

Files Files::complete()
{
    Files files;
    for (const MeshFile& file : mesh_files()) {
        files.add(std::string(file.name), TRIANGLE);
    }
    files.add("texture.tga", tiny_tga());
    return files;
}

void Files::add(const std::string& name, const std::string& text)
{
    files_[name] = text;
}

void Files::remove(const std::string& name)
{
    files_.erase(name);
}

std::vector<AssetFile> Files::views() const
{
    std::vector<AssetFile> views;
    for (const auto& [name, text] : files_) {
        views.push_back({name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}});
    }
    return views;
}

const Assets& tiny_assets()
{
    static const Assets MADE = [] {
        const Files files = Files::complete();
        base::Result<Assets> assets = read_assets(files.views(), PAINT_VIEW);
        if (!assets) {
            std::abort();
        }
        return assets.value();
    }();
    return MADE;
}

Files own_files()
{
    Files files;
    const std::filesystem::path folder = std::filesystem::path(REPOSITORY) / "assets";
    for (const std::filesystem::path& from : {folder, folder / "tankobjs"}) {
        for (const auto& entry : std::filesystem::directory_iterator(from)) {
            if (entry.is_regular_file()) {
                std::ifstream stream(entry.path(), std::ios::binary);
                files.add(entry.path().filename().string(),
                          std::string(std::istreambuf_iterator<char>(stream), {}));
            }
        }
    }
    return files;
}

const Assets& own_assets()
{
    static const Assets MADE = [] {
        const Files files = own_files();
        base::Result<Assets> assets = read_assets(files.views(), PAINT_VIEW);
        if (!assets) {
            std::abort();
        }
        return assets.value();
    }();
    return MADE;
}

} // namespace assets
