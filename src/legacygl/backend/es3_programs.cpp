#include "legacygl/backend/es3_programs.h"

#include "legacygl/backend/es3_shader.h"

#include <cstdio>
#include <string>

namespace legacygl {

ProgramId Es3Programs::create(const ProgramText& text)
{
    Es3Program program;
    program.transform_slots = text.transform_slots;
    program.attributes_read = text.attributes_read;
    std::string message;
    program.name = link_program(gl_, text.vertex, text.fragment, message);
    if (program.name == 0) {
        std::fprintf(stderr, "legacygl: a shader does not compile, please report this: %s\n%s\n%s\n",
                     message.c_str(), text.vertex.c_str(), text.fragment.c_str());
    }
    for (int i = 0; i < UNIFORM_GROUP_COUNT; ++i) {
        program.locations[i] = gl_.GetUniformLocation(program.name, UNIFORM_GROUP_NAMES[i]);
    }
    gl_.UseProgram(program.name);
    for (int unit = 0; unit < SAMPLER_COUNT; ++unit) {
        gl_.Uniform1i(gl_.GetUniformLocation(program.name, ("texture_" + std::to_string(unit)).c_str()),
                      unit);
    }
    used_ = 0;
    ++counters_.programs;
    programs_.push_back(program);
    return static_cast<ProgramId>(programs_.size() - 1);
}

bool Es3Programs::use(ProgramId id)
{
    const GLuint name = programs_[id].name;
    if (used_ != name) {
        gl_.UseProgram(name);
    }
    used_ = name;
    return name != 0;
}

void Es3Programs::upload(ProgramId id, UniformGroup group, const UniformValues& values)
{
    const int i = static_cast<int>(group);
    Es3Program& program = programs_[id];
    if (program.locations[i] < 0 || values.values.empty() ||
        (values.revision != 0 && program.revisions[i] == values.revision)) {
        return;
    }
    program.revisions[i] = values.revision;
    gl_.Uniform4fv(program.locations[i], static_cast<GLsizei>(values.values.size()),
                   &values.values.front().x);
    ++counters_.uniform_uploads;
}

void Es3Programs::clear()
{
    for (const Es3Program& program : programs_) {
        gl_.DeleteProgram(program.name);
    }
    forget();
}

} // namespace legacygl
