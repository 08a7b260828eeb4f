#include "fixtures.h"

#include "app/links/tasks.h"
#include "app/state/fields.h"

namespace app {

double next_unit(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

State random_state(std::mt19937_64& random)
{
    State state;
    for (const Field& field : fields()) {
        if (!field.choices.empty()) {
            set_grid_value(field, state, static_cast<std::int64_t>(random() % field.choices.size()));
            continue;
        }
        switch (random() % 4) {
        case 0: // the default
            break;
        case 1: // an end
            field.set(state, within_limits(field, random() % 2 ? field.minimum : field.maximum));
            break;
        default:
            const double part = next_unit(random);
            field.set(state, within_limits(field, field.minimum + (field.maximum - field.minimum) * part));
        }
    }
    if (random() % 2 == 0) {
        state.task = random() % tasks().size();
    }
    state.tick = random() % 1000;
    state.held[random() % 8] = true;
    return state;
}

} // namespace app
