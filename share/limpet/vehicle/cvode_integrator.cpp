// SPDX-License-Identifier: MIT
#include "limpet/vehicle/cvode_integrator.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "limpet/vehicle/rk4_integrator.hpp"

namespace limpet {
namespace {

/// SUNDIALS objects are freed in the reverse order of their making: the context last.
struct ContextDeleter {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct VectorDeleter {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
struct NonlinearSolverDeleter {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};
struct CvodeDeleter {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
template <class Handle, class Deleter>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Deleter>;

constexpr double kNewCurrent = 0.01;  ///< so much another current is another motion [m/s]

SUNContext MakeContext() {
  SUNContext context = nullptr;
  if (SUNContext_Create(nullptr, &context) != 0) throw std::bad_alloc();
  return context;
}

void Check(int code, const char* what) {
  if (code != CV_SUCCESS) throw std::runtime_error(std::string("CVODE refuses ") + what);
}

/// CVODE hands over vectors of its own, never the one it was given.
/// They end with the last thruster that the vehicle has: what is not there must not count in the
/// error that sets the step.
sunindextype SizeOf(const VehicleModel& model) {
  return state_index::kThrust +
         static_cast<sunindextype>(model.params().thrusters.thrusters.size());
}

StateVector StateOf(N_Vector y) {
  StateVector x = StateVector::Zero();
  const auto size = static_cast<Eigen::Index>(N_VGetLength(y));
  x.head(size) = Eigen::Map<const Eigen::VectorXd>(N_VGetArrayPointer(y), size);
  return x;
}

}  // namespace

/// One CVODE problem: pointers to it are inside CVODE, so it never moves.
class CvodeIntegrator::Solver {
 public:
  Solver(const VehicleModel& model, const StateVector& start, const Options& options);
  ~Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  void Advance(const ThrusterVector& wanted_thrust, double duration,
               std::vector<TimedEvent>& events);

  StateVector x;
  double time = 0.0;
  int failures = 0;

 private:
  static int Rhs(realtype t, N_Vector y, N_Vector rate, void* self);
  static int Roots(realtype t, N_Vector y, realtype* guards, void* self);
  void Restart();
  void CrossGuards(std::vector<TimedEvent>& events);
  void Bridge(double until, std::vector<TimedEvent>& events);

  const VehicleModel* model_;
  EventMonitor monitor_;
  ThrusterVector wanted_thrust_ = ThrusterVector::Zero();
  bool with_seabed_ = true;
  Eigen::Vector3d current_W_ = Eigen::Vector3d::Zero();  ///< at the last restart [m/s]
  Owned<SUNContext, ContextDeleter> context_;
  Owned<N_Vector, VectorDeleter> y_;
  Owned<SUNNonlinearSolver, NonlinearSolverDeleter> iteration_;
  std::unique_ptr<void, CvodeDeleter> cvode_;
};

CvodeIntegrator::Solver::Solver(const VehicleModel& model, const StateVector& start,
                                const Options& options)
    : x(start),
      model_(&model),
      monitor_(model, start),
      context_(MakeContext()),
      y_(N_VMake_Serial(SizeOf(model), x.data(), context_.get())),
      iteration_(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get())),
      cvode_(CVodeCreate(CV_ADAMS, context_.get())) {
  void* const cvode = cvode_.get();
  Check(CVodeInit(cvode, Rhs, 0.0, y_.get()), "the model");
  Check(CVodeSStolerances(cvode, options.relative_tolerance, options.absolute_tolerance),
        "the tolerances");
  Check(CVodeSetUserData(cvode, this), "user data");
  Check(CVodeSetNonlinearSolver(cvode, iteration_.get()), "fixed-point iteration");
  Check(CVodeSetMaxNumSteps(cvode, 20000), "the step limit");
  Check(CVodeRootInit(cvode, EventMonitor::kGuards, Roots), "root finding");
  std::array<int, EventMonitor::kGuards> falling = {-1, -1};
  Check(CVodeSetRootDirection(cvode, falling.data()), "root directions");
  Check(CVodeSetNoInactiveRootWarn(cvode), "quiet roots");
  Check(CVodeSetErrHandlerFn(
            cvode, [](int, const char*, const char*, char*, void*) {}, nullptr),
        "a quiet error handler");  // libraries never print; failures() counts
}

int CvodeIntegrator::Solver::Rhs(realtype, N_Vector y, N_Vector rate, void* self) {
  const auto* solver = static_cast<const Solver*>(self);
  const auto size = static_cast<Eigen::Index>(N_VGetLength(rate));
  Eigen::Map<Eigen::VectorXd>(N_VGetArrayPointer(rate), size) =
      solver->model_->Derivative(StateOf(y), solver->wanted_thrust_, solver->with_seabed_)
          .head(size);
  return 0;
}

int CvodeIntegrator::Solver::Roots(realtype, N_Vector y, realtype* guards, void* self) {
  const auto* solver = static_cast<const Solver*>(self);
  const auto values = solver->monitor_.Guards(StateOf(y), solver->with_seabed_);
  std::ranges::copy(values, guards);
  return 0;
}

void CvodeIntegrator::Solver::Restart() {
  Check(CVodeReInit(cvode_.get(), time, y_.get()), "a restart");
  current_W_ = model_->current_W();
}

void CvodeIntegrator::Solver::CrossGuards(std::vector<TimedEvent>& events) {
  std::array<int, EventMonitor::kGuards> crossed{};
  Check(CVodeGetRootInfo(cvode_.get(), crossed.data()), "root information");
  for (int i = 0; i < EventMonitor::kGuards; ++i) {
    if (crossed[static_cast<std::size_t>(i)] != 0) {
      events.push_back({Seconds(time), monitor_.Cross(i)});
    }
  }
}

/// CVODE gave up (it has not, with smooth contact): fixed steps carry on rather than stop a run.
void CvodeIntegrator::Solver::Bridge(double until, std::vector<TimedEvent>& events) {
  ++failures;
  Rk4Integrator rk4(*model_, x, {.step_s = 0.001});
  std::vector<TimedEvent> found;
  rk4.Advance(wanted_thrust_, until - time, found);
  for (const TimedEvent& event : found) {
    events.push_back({Seconds(time) + event.since_start, event.event});
  }
  x = rk4.state();
  time = until;
  monitor_ = EventMonitor(*model_, x);
}

void CvodeIntegrator::Solver::Advance(const ThrusterVector& wanted_thrust, double duration,
                                      std::vector<TimedEvent>& events) {
  const double until = time + duration;
  const bool with_seabed = model_->IsNearSeabed(x, duration);
  // A vehicle adrift is integrated seconds ahead: with the current that was.
  const bool is_carried_elsewhere = (model_->current_W() - current_W_).norm() > kNewCurrent;
  if (wanted_thrust != wanted_thrust_ || with_seabed != with_seabed_ || time == 0.0 ||
      is_carried_elsewhere) {
    wanted_thrust_ = wanted_thrust;
    with_seabed_ = with_seabed;
    Restart();
  }
  while (time < until) {
    const int code = CVode(cvode_.get(), until, y_.get(), &time, CV_NORMAL);
    if (code == CV_ROOT_RETURN) {
      CrossGuards(events);
      Restart();  // the guard that was crossed now watches its other threshold
    } else if (code < 0) {
      Bridge(until, events);
      Restart();
    }
  }
}

CvodeIntegrator::CvodeIntegrator(const VehicleModel& model, const StateVector& start,
                                 const Options& options)
    : solver_(std::make_unique<Solver>(model, start, options)) {}
CvodeIntegrator::~CvodeIntegrator() = default;
CvodeIntegrator::CvodeIntegrator(CvodeIntegrator&&) noexcept = default;
CvodeIntegrator& CvodeIntegrator::operator=(CvodeIntegrator&&) noexcept = default;

void CvodeIntegrator::Advance(const ThrusterVector& wanted_thrust, double duration,
                              std::vector<TimedEvent>& events) {
  solver_->Advance(wanted_thrust, duration, events);
}
const StateVector& CvodeIntegrator::state() const { return solver_->x; }
double CvodeIntegrator::time() const { return solver_->time; }
int CvodeIntegrator::failures() const { return solver_->failures; }

}  // namespace limpet
