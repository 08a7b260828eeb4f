#pragma once

#include "assets/assets.h"

#include <map>
#include <string>
#include <vector>

namespace assets {

/// The view that tests have the low tank painted for: that of the program.
constexpr PaintView PAINT_VIEW{.field_of_view = 0.7853981633974483, .distance = 259.0};

/// Holds the bytes of a set of files by name, for read_assets.
class Files
{
public:
    /// Makes a complete set: ten meshes of one triangle each, and a texture of two by two pixels.
    static Files complete();

    void add(const std::string& name, const std::string& text);
    void remove(const std::string& name);

    /// Returns views of the files; they last until the set changes.
    std::vector<AssetFile> views() const;

private:
    std::map<std::string, std::string> files_;
};

/// Returns a small TGA picture.
std::string tiny_tga();

/// Returns assets read from Files::complete().
const Assets& tiny_assets();

/// Returns the files of the repository's own tank, and that tank.
Files own_files();
const Assets& own_assets();

} // namespace assets
