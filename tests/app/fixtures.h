#pragma once

#include "app/assets.h"
#include "app/state.h"

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace app {

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

/// Returns a state with random values of every field, anywhere within the limits and mostly off the grid.
State random_state(std::mt19937_64& random);

/// Returns a number in [0, 1).
double next_unit(std::mt19937_64& random);

} // namespace app
