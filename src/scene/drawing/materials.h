#pragma once

namespace scene {

/// Sets what painted steel shines like: its colour comes from the texture, a little gloss from the sun.
void use_tank_material();

/// Lets what is drawn take its colour from glColor while GL_COLOR_MATERIAL is on, without any gloss.
void use_plain_material();

} // namespace scene
