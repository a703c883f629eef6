#include "polylap/apply/flow.hpp"

#include <string>

namespace polylap {

Result<Flow> find_flow(std::string_view name) {
    return guard_memory([&]() -> Result<Flow> {
        std::string known;
        for (std::size_t k = 0; k < flow_names.size(); ++k) {
            if (name == flow_names[k]) return static_cast<Flow>(k);
            known += std::string(k == 0 ? "" : ", ") + flow_names[k];
        }
        return Error{ErrorCode::bad_argument, "there is no flow '" + std::string(name) + "'; the flows are " + known};
    });
}

}  // namespace polylap
