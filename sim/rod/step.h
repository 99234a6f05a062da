#pragma once
// One step of a rod in time.
//
// The default step minimises
//     rho S / 2 int |r(q) - r~|^2 ds + h^2 (U - W) + h / 2 |q - q-|^2_C + contact
// by Gauss-Newton iterations with a line search, each one linear-time solution; C holds
// the damping. Implicit Euler has h = eps, q- = q_t, r~ = r_t + eps v_t. It is a
// least-squares problem, since gravity, air drag and inertia all draw the points of the
// rod towards places, and its matrix is symmetric and positive definite always.
// Velocities are differences of places: a strand has no inertia against twist, so q' may
// be anything while its points hardly move, and J q' is then no velocity.
//
// The semi-implicit step of [Bergbom07, Eq. 5.2, corrected] is kept to compare with: it
// diverges for long, soft hair at frame rate.

#include <functional>
#include <vector>

#include "sim/rod/linear_solver.h"

namespace lancret {

enum class Integrator {
    implicit_euler,  ///< first order, damps what is fast
    bdf2,            ///< second order, hardly damps what the step resolves
    semi_implicit,   ///< one linear solve; velocity terms explicit
};

/// What acts on a rod from outside.
struct RodForces {
    Vec3 gravity = Vec3::Zero();  ///< cm/s^2
    double drag = 0;              ///< nu, of the air on a unit of length, g/(cm s), >= 0
    /// Velocity of the air at a place, cm/s; empty where it is still.
    std::function<Vec3(const Vec3&)> wind;
};

/// An energy of the rod's places that a step minimises with the rest, such as contact.
class RodPotential {
  public:
    virtual ~RodPotential() = default;
    /// The energy, erg, at the linearisation of `system`; its springs and forces, `scale`
    /// times, are added to the system.
    virtual double add_to(RodSystem& system, double scale) = 0;
};

struct StepSettings {
    Integrator integrator = Integrator::implicit_euler;
    LinearSolver solver = LinearSolver::recursion;
    bool velocity_terms = true;  ///< of the semi-implicit step
    int fewest_iterations = 3;   ///< of Gauss-Newton
    int most_iterations = 12;
    double tolerance = 1e-6;  ///< iterations end when no segment turns by more, rad
};

/// What a step did.
struct StepReport {
    bool solved = true;     ///< every matrix was positive definite, every number finite
    bool converged = true;  ///< the tolerance was reached
    int iterations = 0;
    int shortened = 0;  ///< line searches that had to shorten a step
    /// eps/2 times the largest change of velocity of a joint, cm: the leading term of
    /// implicit Euler's local error.
    double local_error = 0;
    double kinetic = 0;  ///< energy at the end of the step, erg, by differences of places
};

/// The poses of a rod before the one at hand, one step apart, latest first: what
/// velocities are told by, and all that a restart needs.
struct RodPast {
    static constexpr int kMax = 4;
    int size = 0;    ///< how many of `poses` there are
    double eps = 0;  ///< the step between them, s
    RodPose poses[kMax];

    void push(const HelixState<double>& root, std::span<const Vec3> curvatures,
              double step);
};

/// Takes steps. Keeps its room between them, so that a step does not allocate once it has
/// seen the largest rod (the dense solvers do). Not to be shared by threads.
class RodStepper {
  public:
    /// Moves `curvatures` and `rates`, [segments], from the time at which the root moves
    /// as `from` to eps (s) later, when it is at `to`, and pushes the pose that was left
    /// onto `past`. Where `past` is empty, and in the semi-implicit step, `rates` and
    /// `from` tell the velocities, otherwise `past`. BDF2 begins with two steps of
    /// implicit Euler, also after a change of eps. Where the report says that it was not
    /// solved nothing has changed.
    StepReport step(const Rod& rod, const RodForces& forces, const StepSettings& settings,
                    const RootMotion& from, const HelixState<double>& to, double eps,
                    std::span<Vec3> curvatures, std::span<Vec3> rates, RodPast& past,
                    RodPotential* potential = nullptr);

    /// The linearisation about the curvatures that the last step came to.
    RodSystem& system() { return system_; }
    /// What the last linear system's solver told.
    const SolveReport& last_solve() const { return last_solve_; }

  private:
    /// Places and velocities of points and joints.
    struct Motion {
        PointVectors places, velocities;
        std::vector<Vec3> joints, joint_velocities;
    };
    void recall(const Rod& rod, const RootMotion& from, std::span<const Vec3> curvatures,
                std::span<const Vec3> rates, const RodPast& past, bool of_bdf2);
    void places_of(const Rod& rod, const RodPose& pose, Motion& motion);
    double begin_bdf2(const Rod& rod, const RodPast& past);
    void aim(const Rod& rod, const RodForces& forces, double h);
    void aim_semi_implicit(const Rod& rod, const RodForces& forces, bool velocity_terms,
                           const RodState& state, double eps);
    double linearize(const Rod& rod, const HelixState<double>& root,
                     std::span<const Vec3> curvatures, double h, RodPotential* potential);
    StepReport minimize(const Rod& rod, const StepSettings& settings,
                        const HelixState<double>& to, double h,
                        std::span<Vec3> curvatures, RodPotential* potential);
    void measure(const Rod& rod, const HelixState<double>& root,
                 std::span<const Vec3> curvatures, double eps, double h,
                 StepReport& report);

    PointLayout layout_;
    Motion now_, before_, earlier_;
    PointVectors targets_;
    RodSystem system_;
    DenseSystem dense_;
    std::vector<Vec3> start_, middle_, joint_starts_, zero_;
    std::vector<Vec3> tried_, diagonal_, load_, change_;
    SolveReport last_solve_;
    double weight_ = 0;
};

}  // namespace lancret
