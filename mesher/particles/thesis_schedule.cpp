#include "mesher/particles/thesis_schedule.h"

#include <algorithm>
#include <deque>
#include <random>
#include <vector>

#include "mesher/errors.h"
#include "mesher/geometry/hilbert.h"
#include "mesher/index.h"
#include "mesher/number_text.h"
#include "mesher/particles/alive_particles.h"
#include "mesher/particles/forces.h"
#include "mesher/particles/neighbourhood.h"
#include "mesher/particles/thesis_moves.h"
#include "mesher/particles/thesis_potential.h"
#include "mesher/particles/thesis_rules.h"

namespace parmesan {
namespace {

/// A particle that came or went.
struct Event {
  std::int64_t pick;
  Point place;
};

class ThesisSchedule {
 public:
  ThesisSchedule(ParticleSystem& particles, const ParticleOptions& options, std::uint64_t seed,
                 std::int64_t max_vertices)
      : particles_(particles),
        options_(options),
        max_vertices_(max_vertices),
        engine_(seed),
        alive_(options.picking),
        neighbours_(options) {
    const Potential potential(options.potential, options.decay);
    const double newton = newton_step(potential, options.neighbourhood, options.radius);
    momentum_ = options.momentum.value_or(0.0);
    step_ = options.step.value_or((1.0 - momentum_) * newton);
    particles_.keep_velocities();
  }

  ThesisReport run(const MeshObserver& observer);

 private:
  bool is_over() const;
  void pick_next();
  void visit(VertexId v);
  double move(VertexId v);
  bool annihilate_if_dense(VertexId v);
  void create_if_sparse(VertexId v);
  void wake(VertexId v);
  void wake_neighbours(VertexId v);
  void note(const Point& p);
  void diagnose();

  ParticleSystem& particles_;
  const ParticleOptions& options_;
  std::int64_t max_vertices_;
  std::mt19937_64 engine_;
  AliveParticles alive_;
  NeighbourSearch neighbours_;
  double momentum_;
  double step_;
  ThesisReport report_;
  std::deque<Event> events_;     // the last ones
  std::vector<VertexId> queue_;  // for picks along the curve: what is left of a sweep, the next one last
};

void ThesisSchedule::wake(VertexId v) {
  if (!alive_.contains(v)) alive_.wake(v, options_.alive_speed);
}

void ThesisSchedule::wake_neighbours(VertexId v) {
  const Triangulation& mesh = particles_.mesh();
  for_each_spoke(mesh, v, [&](EdgeId e) { wake(mesh.dest(e)); });
}

void ThesisSchedule::note(const Point& p) {
  constexpr std::size_t remembered = 2000;
  events_.push_back({report_.picks, p});
  if (events_.size() > remembered) events_.pop_front();
}

// Returns the speed: the metric length of delta v.
double ThesisSchedule::move(VertexId v) {
  if (particles_.binding(v) == fixed_particle) return 0.0;
  const Vector force = force_on(particles_, v, neighbours_.of(particles_, v), options_);
  const Vector velocity = momentum_ * particles_.velocity(v) + step_ * force;
  const Vector moved = relocate(particles_, v, shortened(velocity, particles_.metric(v)), options_.relocation);
  particles_.set_velocity(v, moved);
  return particles_.metric(v).length(moved);
}

bool ThesisSchedule::annihilate_if_dense(VertexId v) {
  if (!is_to_be_annihilated(particles_, v, options_.distance)) return false;
  const Triangulation& mesh = particles_.mesh();
  std::vector<VertexId> ring;
  for_each_spoke(mesh, v, [&](EdgeId e) { ring.push_back(mesh.dest(e)); });
  const Point place = mesh.point(v);
  if (!annihilate(particles_, v, options_.annihilation.value_or(Annihilation::Removal))) return false;
  alive_.put_to_sleep(v);
  for (const VertexId w : ring) wake(w);
  note(place);
  ++report_.annihilated;
  return true;
}

void ThesisSchedule::create_if_sparse(VertexId v) {
  const EdgeId e = edge_to_split(particles_, v, options_.distance, options_.virtual_triangles);
  if (e == no_edge) return;
  if (particles_.mesh().num_vertices() >= max_vertices_)
    throw LimitError("the metric asks for more than " + std::to_string(max_vertices_) + " vertices");
  const VertexId created = create_at(particles_, e, options_.creation);
  if (created == no_vertex) return;
  wake(created);
  wake_neighbours(created);
  note(particles_.mesh().point(created));
  ++report_.created;
}

void ThesisSchedule::visit(VertexId v) {
  const double speed = move(v);
  if (speed > options_.alive_speed) {
    alive_.wake(v, speed);
    wake_neighbours(v);
  } else {
    alive_.put_to_sleep(v);
  }
  if (!annihilate_if_dense(v)) create_if_sparse(v);
}

// Of the last events the one with most others within two unit edges; without events the fastest particle.
void ThesisSchedule::diagnose() {
  const Triangulation& mesh = particles_.mesh();
  while (!events_.empty() && events_.front().pick < report_.picks - report_.picks / 10) events_.pop_front();
  report_.lately_created_or_annihilated = static_cast<std::int64_t>(events_.size());
  report_.diagnosis = std::to_string(report_.alive) + " of " + text(mesh.num_vertices()) +
                      " particles are alive after " + text(options_.max_picks, 6) + " picks per particle: ";
  if (events_.empty()) {
    const auto slower = [&](VertexId a, VertexId b) {
      return particles_.metric(a).length(particles_.velocity(a)) < particles_.metric(b).length(particles_.velocity(b));
    };
    report_.unrest = mesh.point(*std::ranges::max_element(alive_.all(), slower));
    report_.diagnosis += "their motion does not die out";
  } else {
    const auto num_near = [&](const Event& event) {
      MetricHint hint = -1;
      const Metric m = particles_.evaluate(event.place, hint);
      return std::ranges::count_if(events_,
                                   [&](const Event& other) { return m.length(other.place - event.place) < 2; });
    };
    report_.unrest = std::ranges::max_element(events_, {}, num_near)->place;
    report_.diagnosis += "they are created and annihilated in turn";
  }
  report_.diagnosis += ", most near " + text(report_.unrest, 6);
}

bool ThesisSchedule::is_over() const {
  return alive_.empty() || static_cast<double>(report_.picks) >= options_.max_picks * particles_.mesh().num_vertices();
}

// A sweep has those alive when it begins; who has died before its turn is left out.
void ThesisSchedule::pick_next() {
  ++report_.picks;
  if (options_.picking != Picking::Hilbert) return visit(alive_.pick(engine_));
  while (!queue_.empty() && !alive_.contains(queue_.back())) queue_.pop_back();
  if (queue_.empty()) {
    std::vector<Point> places;
    for (const VertexId v : alive_.all()) places.push_back(particles_.mesh().point(v));
    for (const int i : hilbert_order(places)) queue_.push_back(alive_.all()[at(i)]);
  }
  const VertexId v = queue_.back();
  queue_.pop_back();
  visit(v);
}

ThesisReport ThesisSchedule::run(const MeshObserver& observer) {
  const Triangulation& mesh = particles_.mesh();
  for (VertexId v = 0; v < mesh.num_slots(); ++v)
    if (mesh.has_vertex(v)) wake(v);
  while (!is_over()) {
    if (observer) observer(particles_, report_.picks);
    pick_next();
  }
  if (observer) observer(particles_, report_.picks);
  report_.alive = alive_.size();
  report_.settled = alive_.empty();
  if (!report_.settled) diagnose();
  return report_;
}

}  // namespace

ThesisReport run_thesis_schedule(ParticleSystem& particles, const ParticleOptions& options, std::uint64_t seed,
                                 std::int64_t max_vertices, const MeshObserver& observer) {
  validate(options);
  return ThesisSchedule(particles, options, seed, max_vertices).run(observer);
}

}  // namespace parmesan
