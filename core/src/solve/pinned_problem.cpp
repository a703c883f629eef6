#include "polylap/solve/pinned_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "solve/fixed_vertices.hpp"
#include "solve/lower_triangle.hpp"

namespace polylap {
namespace {

/// Potentials solved for at once: between them, the work can be stopped. The factor is read once for all of them.
constexpr std::size_t block = 8;
/// Rows added up at once: few enough to stay in the fastest cache while the potentials pass by.
constexpr Eigen::Index row_block = 1024;
/// A pin's resistance to the pins before it, relative to the largest potential: what is lost to cancellation.
constexpr double resistance_tolerance = 1e-6;

// The cost of things, in operations of the numeric factorisation. Measured on quad tori of 450 to 250 000 vertices with
// one thread: an operation takes 0.03 to 0.1 ns, an analysis 27 to 53 ns per entry of L, a block of solves 2.5 to 4 ns
// per entry, an operation of the dense factor of the pins' system 0.07 to 0.17 ns.
constexpr double analysis_cost = 1000;  ///< Per entry of L.
constexpr double block_cost = 100;      ///< Per entry of L.
constexpr double dense_cost = 4;        ///< Per operation; pins³/3 of them.
/// L has at most this many operations per entry on meshes that fit into memory (250k vertices: 330; 1M: about 400).
constexpr double most_operations = 600;

double blocks(std::size_t pins) {
    return std::ceil(static_cast<double>(pins) / static_cast<double>(block));
}

bool holds(std::size_t pins, Eigen::Index vertices) {
    constexpr auto most = static_cast<double>(PinnedProblem::most_bytes);
    return static_cast<double>(pins) * static_cast<double>(vertices) * sizeof(double) <= most;
}

/// Parts of the graph of nonzero entries.
struct Parts {
    std::vector<Index> part;    ///< Per vertex; -1: no entry.
    std::vector<Index> lowest;  ///< Per part.
    std::vector<Index> ground;  ///< Per part, the vertex of the largest diagonal entry, the lowest of several.
};

Parts find_parts(const SparseMatrix& s) {
    Parts parts;
    const auto n = static_cast<Index>(s.cols());
    // Towards the lowest vertex of what is known to be connected; -1: in no entry.
    std::vector<Index>& lower = parts.part;
    lower.assign(static_cast<std::size_t>(n), -1);
    const auto lowest = [&](Index v) {
        while (lower[static_cast<std::size_t>(v)] != v) {
            Index& next = lower[static_cast<std::size_t>(v)];
            next = lower[static_cast<std::size_t>(next)];
            v = next;
        }
        return v;
    };
    Vector diagonal = Vector::Zero(n);
    for (Index v = 0; v < n; ++v) {
        for (SparseMatrix::InnerIterator it(s, v); it && it.index() <= v; ++it) {
            if (it.value() == 0) continue;
            const Index w = it.index();
            for (const Index end : {v, w}) {
                if (lower[static_cast<std::size_t>(end)] < 0) lower[static_cast<std::size_t>(end)] = end;
            }
            if (w == v) {
                diagonal[v] = it.value();
            } else {
                const Index a = lowest(v);
                const Index b = lowest(w);
                lower[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
            }
        }
    }
    for (Index v = 0; v < n; ++v) {  // what a vertex points to has its part's number by now
        Index& part = lower[static_cast<std::size_t>(v)];
        if (part < 0) continue;
        if (part == v) {
            part = static_cast<Index>(parts.lowest.size());
            parts.lowest.push_back(v);
            parts.ground.push_back(v);
        } else {
            part = lower[static_cast<std::size_t>(part)];
            Index& ground = parts.ground[static_cast<std::size_t>(part)];
            if (diagonal[v] > diagonal[ground]) ground = v;
        }
    }
    return parts;
}

/// The lower triangle of S_g, with a 1 where a vertex is in no equation.
SparseMatrix ground(const SparseMatrix& s, const Parts& parts) {
    SparseMatrix grounded = lower_triangle(s);
    const auto n = static_cast<Index>(s.cols());
    std::vector<Index> missing;  // where no diagonal entry is stored
    const auto add = [&](Index v, double value) {
        Index* const first = grounded.innerIndexPtr() + grounded.outerIndexPtr()[v];
        Index* const last = grounded.innerIndexPtr() + grounded.outerIndexPtr()[v + 1];
        Index* const found = std::lower_bound(first, last, v);
        if (found == last || *found != v) {
            missing.push_back(v);
        } else {
            grounded.valuePtr()[found - grounded.innerIndexPtr()] += value;
        }
    };
    for (const Index g : parts.ground) {
        add(g, s.coeff(g, g));
    }
    for (Index v = 0; v < n; ++v) {
        if (parts.part[static_cast<std::size_t>(v)] < 0) add(v, 1);
    }
    if (missing.empty()) return grounded;
    SparseMatrix ones(n, n);
    ones.reserve(static_cast<Eigen::Index>(missing.size()));
    std::sort(missing.begin(), missing.end());
    for (const Index v : missing) {
        ones.insert(v, v) = 1;
    }
    ones.makeCompressed();
    return grounded + ones;
}

}  // namespace

Result<PinnedProblem> PinnedProblem::create(const SparseMatrix& stiffness, const Points& positions,
                                            std::span<const std::shared_ptr<const SpdAnalysis>> known,
                                            Monitor monitor) {
    if (stiffness.rows() != stiffness.cols() || !stiffness.isCompressed()) {
        return Error{ErrorCode::bad_argument, "the stiffness has " + std::to_string(stiffness.rows()) + " rows and " +
                                                  std::to_string(stiffness.cols()) +
                                                  " columns; it must be square and compressed"};
    }
    return guard_memory([&]() -> Result<PinnedProblem> {
        PinnedProblem problem;
        Parts parts = find_parts(stiffness);
        problem.grounded_ = std::make_unique<SparseMatrix>();
        ground(stiffness, parts).swap(*problem.grounded_);
        problem.part_ = std::move(parts.part);
        problem.part_lowest_ = std::move(parts.lowest);
        const auto fitting = std::find_if(known.begin(), known.end(), [&](const auto& analysis) {
            return analysis != nullptr && analysis->fits(*problem.grounded_);
        });
        if (fitting != known.end()) {
            problem.factor_.use(*fitting);
        } else if (Status status = problem.factor_.analyse(*problem.grounded_, positions, monitor); !status) {
            return status.error();
        }
        return problem;
    });
}

std::int64_t PinnedProblem::bytes() const noexcept {
    return factor_.bytes() + static_cast<std::int64_t>(potentials_.size() * part_.size() * sizeof(double));
}

bool PinnedProblem::may_pay(std::size_t pins, Eigen::Index vertices) noexcept {
    return holds(pins, vertices) && blocks(pins) * block_cost <= analysis_cost + most_operations;
}

bool PinnedProblem::pays(std::span<const Index> pins) const {
    const auto missing = static_cast<std::size_t>(
        std::count_if(pins.begin(), pins.end(), [&](Index pin) { return find(pin) == potentials_.end(); }));
    const auto entries = static_cast<double>(analysis()->factor_entries());
    const double dense = dense_cost * std::pow(static_cast<double>(pins.size()), 3) / 3;
    return holds(pins.size(), static_cast<Eigen::Index>(part_.size())) &&
           blocks(missing) * block_cost * entries + dense <= analysis_cost * entries + analysis()->factor_flops();
}

std::vector<PinnedProblem::Potential>::const_iterator PinnedProblem::find(Index vertex) const {
    return std::find_if(potentials_.begin(), potentials_.end(), [&](const Potential& p) { return p.vertex == vertex; });
}

Result<Vector> PinnedProblem::solve(std::span<const Index> pins, const Eigen::Ref<const Vector>& values,
                                    Monitor monitor) {
    return guard_memory([&]() -> Result<Vector> {
        if (!chosen_ || !std::equal(pins.begin(), pins.end(), pins_.begin(), pins_.end())) {
            if (Status status = choose(pins, monitor); !status) return status.error();
        }
        if (Status status = check_values(pins, values); !status) return status.error();

        Vector sources = Vector::Zero(values.size());
        Vector constants = Vector::Zero(static_cast<Eigen::Index>(anchor_.size()));
        Vector asked(static_cast<Eigen::Index>(reduced_.size()));
        const auto part_of = [&](Index place) {
            return part_[static_cast<std::size_t>(pins[static_cast<std::size_t>(place)])];
        };
        const auto anchor_of = [&](Index place) { return anchor_[static_cast<std::size_t>(part_of(place))]; };
        for (Eigen::Index k = 0; k < asked.size(); ++k) {
            const Index place = reduced_[static_cast<std::size_t>(k)];
            asked[k] = values[place] - values[anchor_of(place)];
        }
        if (asked.size() > 0) asked = system_->solve(asked);
        for (Eigen::Index k = 0; k < asked.size(); ++k) {
            const Index place = reduced_[static_cast<std::size_t>(k)];
            sources[place] = asked[k];
            sources[anchor_of(place)] -= asked[k];
        }
        for (Eigen::Index part = 0; part < constants.size(); ++part) {
            constants[part] = values[anchor_[static_cast<std::size_t>(part)]];
        }
        for (Index place = 0; place < sources.size(); ++place) {
            if (part_of(place) < 0 || sources[place] == 0) continue;
            const Index at = pins[static_cast<std::size_t>(anchor_of(place))];
            constants[part_of(place)] -= sources[place] * potentials_[static_cast<std::size_t>(place)].values[at];
        }

        const auto n = static_cast<Eigen::Index>(part_.size());
        Vector u(n);
        bool finite = true;
        for (Eigen::Index from = 0; from < n; from += row_block) {
            auto rows = u.segment(from, std::min(row_block, n - from));
            for (Eigen::Index k = 0; k < rows.size(); ++k) {
                const Index part = part_[static_cast<std::size_t>(from + k)];
                rows[k] = part < 0 ? 0 : constants[part];
            }
            for (Eigen::Index place = 0; place < sources.size(); ++place) {
                if (sources[place] == 0) continue;
                rows += sources[place] * potentials_[static_cast<std::size_t>(place)].values.segment(from, rows.size());
            }
            finite = finite && rows.allFinite();
            for (Eigen::Index k = 0; k < rows.size(); ++k) {
                if (part_[static_cast<std::size_t>(from + k)] < 0) rows[k] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        if (!finite) return values_too_far_apart();
        for (std::size_t place = 0; place < pins.size(); ++place) {
            u[pins[place]] = values[static_cast<Eigen::Index>(place)];
        }
        return u;
    });
}

Status PinnedProblem::choose(std::span<const Index> pins, Monitor monitor) {
    const auto places = places_of(pins, static_cast<Index>(part_.size()));
    if (!places) return places.error();
    std::vector<Index> anchor(part_lowest_.size(), -1);
    std::vector<Index> reduced;
    for (std::size_t place = 0; place < pins.size(); ++place) {
        const Index part = part_[static_cast<std::size_t>(pins[place])];
        if (part < 0) continue;
        if (anchor[static_cast<std::size_t>(part)] < 0) {
            anchor[static_cast<std::size_t>(part)] = static_cast<Index>(place);
        } else {
            reduced.push_back(static_cast<Index>(place));
        }
    }
    for (std::size_t part = 0; part < anchor.size(); ++part) {
        if (anchor[part] < 0) return unconstrained_part(part_lowest_[part]);
    }
    Stretch factoring{monitor, 0, 0.7};
    if (grounded_) {
        if (Status status = factor_.factor(*grounded_, factoring.monitor()); !status) return status;
        grounded_.reset();
    }
    chosen_ = false;
    Stretch solving{monitor, 0.7, 1};
    if (Status status = fetch_potentials(pins, solving.monitor()); !status) return status;
    anchor_ = std::move(anchor);
    reduced_ = std::move(reduced);
    if (Status status = reduce(); !status) return status;
    pins_.assign(pins.begin(), pins.end());
    chosen_ = true;
    return Done{};
}

/// Brings the pins' potentials to the front, solving for those that are missing.
Status PinnedProblem::fetch_potentials(std::span<const Index> pins, Monitor monitor) {
    std::vector<Potential> fetched;
    std::vector<std::size_t> missing;
    for (const Index pin : pins) {
        if (const auto known = find(pin); known != potentials_.end()) {
            Potential& own = potentials_[static_cast<std::size_t>(known - potentials_.begin())];
            fetched.push_back(std::exchange(own, {-1, {}}));
        } else {
            if (part_[static_cast<std::size_t>(pin)] >= 0) missing.push_back(fetched.size());
            fetched.push_back({pin, {}});
        }
    }
    for (Potential& other : potentials_) {
        if (other.vertex >= 0) fetched.push_back(std::move(other));
    }
    const auto n = static_cast<Eigen::Index>(part_.size());
    const auto solve_block = [&](std::span<const std::size_t> places) -> Status {
        Matrix sources = Matrix::Zero(n, static_cast<Eigen::Index>(places.size()));
        for (std::size_t k = 0; k < places.size(); ++k) {
            sources(fetched[places[k]].vertex, static_cast<Eigen::Index>(k)) = 1;
        }
        const auto potentials = factor_.solve(sources);
        if (!potentials) return potentials.error();
        for (std::size_t k = 0; k < places.size(); ++k) {
            fetched[places[k]].values = potentials->col(static_cast<Eigen::Index>(k));
        }
        return Done{};
    };
    Status status = Done{};
    for (std::size_t k = 0; k < missing.size() && status; k += block) {
        if (!monitor.proceed(static_cast<double>(k) / static_cast<double>(missing.size()))) {
            status = Error{ErrorCode::cancelled, "cancelled"};
        } else {
            status = solve_block(std::span(missing).subspan(k, std::min(block, missing.size() - k)));
        }
    }
    if (!status) std::erase_if(fetched, [](const Potential& p) { return p.values.size() == 0; });
    while (fetched.size() > pins.size() && !holds(fetched.size(), n)) {
        fetched.pop_back();
    }
    potentials_ = std::move(fetched);
    return status;
}

/// The dense system of the sources: c_j raises the difference between pin i and its part's first pin a by
/// (e_i - e_a)ᵀ S_g⁻¹ (e_j - e_a), where a takes what j gives.
Status PinnedProblem::reduce() {
    const auto count = static_cast<Eigen::Index>(reduced_.size());
    Matrix system = Matrix::Zero(count, count);
    double largest = 0;
    for (Eigen::Index l = 0; l < count; ++l) {
        const Potential& source = potentials_[static_cast<std::size_t>(reduced_[static_cast<std::size_t>(l)])];
        const Index part = part_[static_cast<std::size_t>(source.vertex)];
        const Potential& sink = potentials_[static_cast<std::size_t>(anchor_[static_cast<std::size_t>(part)])];
        largest = std::max({largest, source.values[source.vertex], sink.values[sink.vertex]});
        for (Eigen::Index k = l; k < count; ++k) {
            const Index at = potentials_[static_cast<std::size_t>(reduced_[static_cast<std::size_t>(k)])].vertex;
            if (part_[static_cast<std::size_t>(at)] != part) continue;
            system(k, l) =
                (source.values[at] - source.values[sink.vertex]) - (sink.values[at] - sink.values[sink.vertex]);
        }
    }
    system_.emplace(system);
    const auto least = count == 0 ? 1 : system_->matrixLLT().diagonal().cwiseAbs2().minCoeff();
    if (system_->info() == Eigen::Success && least >= resistance_tolerance * largest) return Done{};
    return Error{ErrorCode::not_converged, "the pins are too strongly coupled to solve for them by their potentials"};
}

}  // namespace polylap
