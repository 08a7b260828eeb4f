#include "scene/surroundings.h"

#include "scene/degrees.h"
#include "scene/ground.h"
#include "scene/sky.h"

#include <GL/gl.h>

namespace scene {

bool Surroundings::load()
{
    first_list_ = glGenLists(LIST_COUNT);
    if (first_list_ == 0) {
        return false;
    }
    glNewList(first_list_ + SKY, GL_COMPILE);
    draw_sky_dome();
    glEndList();
    glNewList(first_list_ + GROUND, GL_COMPILE);
    draw_earth();
    glEndList();
    glNewList(first_list_ + METRE_GRID, GL_COMPILE);
    draw_metre_grid();
    glEndList();
    glNewList(first_list_ + CONTACT_SHADOW, GL_COMPILE);
    draw_contact_shadow();
    glEndList();
    return true;
}

void Surroundings::draw_sky(const app::CameraView& camera) const
{
    const double radius = 0.5 * (camera.near_plane + camera.far_plane); // any between would do
    glDisable(GL_LIGHTING);
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glPushMatrix();
    glTranslated(camera.eye.x, camera.eye.y, camera.eye.z);
    glScaled(radius, radius, radius);
    glCallList(first_list_ + SKY);
    glPopMatrix();
}

void Surroundings::draw_ground(const app::Frame& frame) const
{
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);

    glEnable(GL_LIGHTING);
    glEnable(GL_COLOR_MATERIAL);
    glCallList(first_list_ + GROUND);
    glDisable(GL_COLOR_MATERIAL);
    glDisable(GL_LIGHTING);

    glCallList(first_list_ + METRE_GRID);
    for (const app::TankInFrame& tank : frame.used_tanks()) {
        glPushMatrix();
        glTranslated(tank.position.x, tank.position.y, tank.position.z);
        glRotatef(degrees(tank.joints[tank::Joint::heading]), 0.0f, 1.0f, 0.0f);
        glCallList(first_list_ + CONTACT_SHADOW);
        glPopMatrix();
    }

    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

} // namespace scene
