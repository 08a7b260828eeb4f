#include "recording_gl.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <set>

#include <GL/gl.h>

namespace recording_gl {
namespace {

glm::dmat4 translation(double x, double y, double z)
{
    glm::dmat4 m(1.0);
    m[3] = {x, y, z, 1.0};
    return m;
}

glm::dmat4 scaling(double x, double y, double z)
{
    glm::dmat4 m(1.0);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

/// OpenGL 1.5, 2.11.2: R = u u^T + cos a (I - u u^T) + sin a S.
glm::dmat4 rotation(double degrees, const glm::dvec3& axis)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const glm::dvec3 u = glm::normalize(axis);
    const glm::dmat3 cross(0.0, u.z, -u.y, -u.z, 0.0, u.x, u.y, -u.x, 0.0); // columns
    return glm::dmat4(glm::outerProduct(u, u) * (1.0 - c) + glm::dmat3(c) + s * cross);
}

/// GLU 1.3, gluLookAt.
glm::dmat4 look_at(const std::vector<double>& v)
{
    const glm::dvec3 eye(v[0], v[1], v[2]);
    const glm::dvec3 f = glm::normalize(glm::dvec3(v[3], v[4], v[5]) - eye);
    const glm::dvec3 s = glm::normalize(glm::cross(f, glm::dvec3(v[6], v[7], v[8])));
    const glm::dvec3 u = glm::cross(s, f);
    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = s[i];
        m[i][1] = u[i];
        m[i][2] = -f[i];
    }
    return m * translation(-eye.x, -eye.y, -eye.z);
}

} // namespace

namespace {

/// Takes in a call that sets a value. Materials and lights, which every drawing sets anew, are left out.
void set(Settings& settings, const Call& call)
{
    for (const char* name :
         {"glBlendFunc", "glDepthFunc", "glDepthMask", "glCullFace", "glFrontFace", "glShadeModel",
          "glLineWidth", "glPolygonMode", "glMatrixMode", "glStencilFunc", "glStencilOp"}) {
        if (call.name == name) {
            settings[name] = call.arguments;
        }
    }
    if (call.name == "glColor3ub" || call.name == "glColor4ub") {
        settings["colour"] = call.arguments;
        settings["colour"].resize(4, 255.0);
    }
    // Arrays count as settings, too: they are on or off for the client.
    if (call.name == "glInterleavedArrays") {
        for (unsigned array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY}) {
            settings["array " + std::to_string(array)] = {1.0};
        }
    } else if (call.name == "glDisableClientState") {
        settings.erase("array " + std::to_string(static_cast<unsigned>(call.arguments[0])));
    }
}

} // namespace

bool ListCall::is_enabled(unsigned capability) const
{
    return std::binary_search(enabled.begin(), enabled.end(), capability);
}

Replay replay(const std::vector<Call>& calls)
{
    Replay result;
    std::vector<glm::dmat4> stack = {glm::dmat4(1.0)};
    std::set<unsigned> enabled;
    bool modelview = true;
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const Call& call = calls[i];
        const std::vector<double>& a = call.arguments;
        if (call.compiled_into != 0) {
            continue;
        }
        set(result.final_settings, call);
        if (call.name == "glMatrixMode") {
            modelview = a[0] == GL_MODELVIEW;
        } else if (call.name == "glEnable") {
            enabled.insert(static_cast<unsigned>(a[0]));
        } else if (call.name == "glDisable") {
            enabled.erase(static_cast<unsigned>(a[0]));
        } else if (call.name == "glDepthMask") {
            result.final_depth_writes = a[0] != 0.0;
        } else if (call.name == "glLightfv" && a[1] == GL_POSITION) {
            result.light_positions_set_under.push_back(stack.back());
        } else if (call.name == "glCallList" || call.name == "glBegin" || call.name == "glDrawArrays") {
            const bool is_list = call.name == "glCallList";
            (is_list ? result.list_calls : result.direct_draws)
                .push_back({is_list ? static_cast<unsigned>(a[0]) : 0u,
                            stack.back(),
                            {enabled.begin(), enabled.end()},
                            result.final_depth_writes,
                            stack.size() - 1,
                            result.final_settings,
                            i});
        }
        if (!modelview) {
            continue;
        }
        if (call.name == "glLoadIdentity") {
            stack.back() = glm::dmat4(1.0);
        } else if (call.name == "gluLookAt") {
            stack.back() = stack.back() * look_at(a);
        } else if (call.name == "glTranslate") {
            stack.back() = stack.back() * translation(a[0], a[1], a[2]);
        } else if (call.name == "glScale") {
            stack.back() = stack.back() * scaling(a[0], a[1], a[2]);
        } else if (call.name == "glRotate") {
            stack.back() = stack.back() * rotation(a[0], {a[1], a[2], a[3]});
        } else if (call.name == "glMultMatrixd" || call.name == "glMultMatrixf") {
            glm::dmat4 factor;
            std::copy(a.begin(), a.end(), &factor[0][0]);
            stack.back() = stack.back() * factor;
        } else if (call.name == "glPushMatrix") {
            stack.push_back(stack.back());
        } else if (call.name == "glPopMatrix" && stack.size() == 1) {
            result.popped_too_often = true;
        } else if (call.name == "glPopMatrix") {
            stack.pop_back();
        }
    }
    result.final_stack_depth = stack.size() - 1;
    result.final_enabled.assign(enabled.begin(), enabled.end());
    return result;
}

} // namespace recording_gl
