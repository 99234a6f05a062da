#pragma once
// One step of a rod in time.
//
// The default step minimises
//     rho S / 2 int |r(q) - r~|^2 ds + h^2 (U - W) + h / 2 |q - q-|^2_C + contact
// by Gauss-Newton iterations with a line search, each one linear-time solution; C holds
// the damping. For implicit Euler h = eps, q- = q_t and r~ = r_t + eps v_t. This is a
// least-squares problem, since gravity, air drag and inertia all draw the points of the
// rod towards target positions, and its matrix is always symmetric and positive definite.
// Velocities are differences of positions: a strand has no inertia against twist, so q'
// may take any value while its points hardly move, and J q' is then not their velocity.
//
// The semi-implicit step of [Bergbom07, Eq. 5.2, corrected] is provided for comparison:
// it diverges for long, soft hair at frame rate.

#include <functional>
#include <vector>

#include "guides/base/named.h"
#include "sim/rod/linear_solver.h"

namespace lancret {

enum class Integrator {
    implicit_euler,  ///< first order, damps what is fast
    bdf2,            ///< second order, hardly damps what the step resolves
    semi_implicit,   ///< one linear solve; velocity terms explicit
};
inline constexpr Named<Integrator> kIntegratorNames[] = {
    {Integrator::implicit_euler, "implicit-euler"},
    {Integrator::bdf2, "bdf2"},
    {Integrator::semi_implicit, "semi-implicit"}};

/// The external forces on a rod, apart from contact.
struct RodForces {
    Vec3 gravity = Vec3::Zero();  ///< cm/s^2
    double drag = 0;              ///< nu, of the air per unit of length, g/(cm s), >= 0
    /// Velocity of the air at a position, cm/s; empty if the air is still.
    std::function<Vec3(const Vec3&)> wind;
};

/// An energy of the rod's positions, such as contact, that a step minimises with the
/// rest.
class RodPotential {
  public:
    virtual ~RodPotential() = default;
    /// Returns `scale` times the energy, erg, at the linearisation of `system`, and adds
    /// its springs and forces, times `scale`, to the system.
    virtual double add_to(RodSystem& system, double scale) = 0;
};

struct StepSettings {
    Integrator integrator = Integrator::implicit_euler;
    LinearSolver solver = LinearSolver::recursion;
    bool velocity_terms = true;  ///< of the semi-implicit step
    int min_iterations = 3;      ///< of Gauss-Newton
    int max_iterations = 12;
    double tolerance = 1e-6;  ///< iterations end when no segment turns by more, rad
};

/// The outcome of a step.
struct StepReport {
    bool solved = true;     ///< every matrix was positive definite, every number finite
    bool converged = true;  ///< the tolerance was reached
    int iterations = 0;
    int shortened = 0;  ///< line searches that had to shorten a step
    /// eps/2 times the largest change of velocity of a joint, cm: the leading term of
    /// implicit Euler's local error.
    double local_error = 0;
    /// Kinetic energy at the end of the step, erg, from differences of positions.
    double kinetic = 0;
};

/// The previous poses of a rod, one step apart, latest first: the history that velocities
/// are differenced from, and the restart state.
struct RodPast {
    static constexpr int kMax = 4;
    int size = 0;    ///< number of valid `poses`
    double eps = 0;  ///< the step between them, s
    RodPose poses[kMax];

    /// Adds the latest pose. If `step` differs from `eps`, the others are dropped.
    void push(const HelixState<double>& root, std::span<const Vec3> curvatures,
              double step);
};

/// The step to take and the state that it changes.
struct RodMotionStep {
    const RootMotion& from;        ///< the root at the start
    const HelixState<double>& to;  ///< the root at the end
    double eps;                    ///< s
    std::span<Vec3> curvatures;    ///< [segments], q, 1/cm, replaced by those at the end
    std::span<Vec3> rates;         ///< [segments], q', 1/(cm s), likewise
    RodPast& past;                 ///< the pose at the start is pushed onto it
};

/// Takes steps. Keeps its buffers between them, so that a step does not allocate once it
/// has seen the largest rod (the dense solvers do). Not to be shared by threads.
class RodStepper {
  public:
    /// Takes one step. If `step.past` is empty, and in the semi-implicit step, `rates`
    /// and `from` give the velocities, otherwise `past` does. BDF2 starts with two steps
    /// of implicit Euler, also after a change of eps. If the report is not `solved`,
    /// nothing has changed.
    StepReport step(const Rod& rod, const RodForces& forces, const StepSettings& settings,
                    const RodMotionStep& step, RodPotential* potential = nullptr);

    /// The linearisation about the curvatures at the end of the last step.
    RodSystem& system() { return system_; }

  private:
    /// Positions and velocities of the quadrature points and of the joints.
    struct Motion {
        PointVectors positions, velocities;
        std::vector<Vec3> joints, joint_velocities;
    };
    void recall(const Rod& rod, const RodMotionStep& step, const RodPast& past,
                bool of_bdf2);
    void find_positions(const Rod& rod, const RodPose& pose, Motion& motion);
    double begin_bdf2(const Rod& rod, const RodPast& past);
    void aim(const Rod& rod, const RodForces& forces, double h);
    void aim_semi_implicit(const Rod& rod, const RodForces& forces, bool velocity_terms,
                           const RodState& state, double eps);
    double linearize(const Rod& rod, const HelixState<double>& root,
                     std::span<const Vec3> curvatures, double h, RodPotential* potential);
    void solve_change(const StepSettings& settings, StepReport& report);
    StepReport minimize(const Rod& rod, const StepSettings& settings,
                        const RodMotionStep& step, double h, RodPotential* potential);
    StepReport solve_semi_implicit(const Rod& rod, const RodForces& forces,
                                   const StepSettings& settings,
                                   const RodMotionStep& step, RodPotential* potential);
    void measure(const Rod& rod, const RodMotionStep& step, double h, StepReport& report);

    PointLayout layout_;
    Motion now_;      ///< extrapolated by inertia: the current motion, or BDF2's mean
    Motion before_;   ///< one step earlier
    Motion earlier_;  ///< two or three steps earlier
    PointVectors targets_;
    double weight_ = 0;  ///< strength of the springs to the targets, g/cm
    RodSystem system_;
    DenseSystem dense_;
    std::vector<Vec3> start_curvatures_;  ///< at the start of the step
    std::vector<Vec3> base_curvatures_;   ///< q-, which rates are differenced from
    std::vector<Vec3> tried_curvatures_;
    std::vector<Vec3> diagonal_, load_, change_;
    // Only for the semi-implicit step: the points' motion without rates.
    std::vector<Vec3> zero_rates_, carried_joints_;
    PointVectors carried_velocities_, bias_;
    // Only for measure().
    PointVectors end_positions_;
    std::vector<Vec3> end_joints_;
};

}  // namespace lancret
