package org.dfra.sim.world;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.NearestName;
import org.dfra.geometry.LocalFrame;
import org.dfra.sim.world.VehicleBody.BodyContext;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.noise.CorrelatedNoise;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.ObstacleIndex;
import org.dfra.sim.world.shape.StaticObstacle;
import org.jspecify.annotations.Nullable;

/**
 * A world in time. It advances in steps of {@link #STEP} when a caller requests a later time, and
 * never on its own; between two steps its state is constant.
 *
 * <p>A query for a time up to two seconds before the latest requested time gets the state of that
 * time; an older one, the oldest stored state. A command for a time before the latest requested one
 * takes effect from the next step on, and is counted as late ({@link GroundTruth#lateCommands}).
 * Where one clock steps all participants, no command is late, and the whole run is
 * bit-reproducible.
 *
 * <p>Thread-safe; the world is one monitor.
 */
public final class World {

  /** From one step to the next. */
  public static final Duration STEP = Duration.ofMillis(10);

  static final double STEP_SECONDS = 0.01;

  /** A larger jump of the clock is an error. */
  private static final Duration LONGEST_LEAP = Duration.ofDays(2);

  private final WorldDescription description;
  private final Timeline timeline;
  private final LocalFrame frame;
  private final Object monitor = new Object();
  private final Map<String, SimulatedRobot> robots = new TreeMap<>();
  private final ObstacleIndex solids;
  private final List<VehicleBody> bodies = new ArrayList<>();
  private final List<SimulatedPanTilt> heads = new ArrayList<>();
  private final CollisionDetector contacts;
  private final StateHistory history; // guarded by the monitor
  private final ArrayDeque<Runnable> commands = new ArrayDeque<>(); // guarded by the monitor
  private long lateCommands; // guarded by the monitor
  private @Nullable RenderScene scene; // guarded by the monitor

  private World(WorldDescription description, Instant start) {
    this.description = description;
    this.timeline = new Timeline(start);
    this.frame = new LocalFrame(description.datum());
    this.solids =
        new ObstacleIndex(
            description.obstacles().stream()
                .map(o -> new StaticObstacle(o.name(), o.footprint(), o.height(), o.reflectivity()))
                .toList());
    this.contacts = new CollisionDetector(solids, bodies);
    StateLayout slots = new StateLayout();
    RandomStream draws = new RandomStream(description.seed());
    BodyContext around =
        new BodyContext(
            slots,
            new Terrain(description.ground().roughness(), draws.substream("terrain")),
            contacts,
            description.weather(),
            draws.substream("robots"));
    for (VehicleDescription vehicle : description.vehicles()) {
      VehicleBody body = body(vehicle, around);
      bodies.add(body);
      robots.put(vehicle.name(), new SimulatedRobot(this, body, slots, heads));
    }
    this.history = new StateHistory(slots.columns());
    write(history.row(0));
  }

  /**
   * Creates a world.
   *
   * @param start of its time; before that its state is the initial one
   */
  public static World of(WorldDescription description, Instant start) {
    return new World(description, start);
  }

  private VehicleBody body(VehicleDescription vehicle, BodyContext around) {
    return vehicle.type() == VehicleType.UGV
        ? new SkidSteerBody(vehicle, bodies.size(), around)
        : MulticopterBody.of(vehicle, bodies.size(), around);
  }

  /** Its description. */
  public WorldDescription description() {
    return description;
  }

  /** The start of its time. */
  public Instant start() {
    return timeline.start();
  }

  /** The world's frame on the earth: ENU at the datum. */
  public LocalFrame frame() {
    return frame;
  }

  /** The latest requested step. */
  public Instant time() {
    synchronized (monitor) {
      return instant(history.last());
    }
  }

  /**
   * One of its robots.
   *
   * @throws IllegalArgumentException if it has none of that name
   */
  public SimulatedRobot robot(String name) {
    SimulatedRobot robot = robots.get(name);
    if (robot == null) {
      throw new IllegalArgumentException(
          "the world "
              + description.name()
              + " has no robot \""
              + name
              + "\""
              + NearestName.hint(name, robots.keySet(), "; it has " + robots.keySet()));
    }
    return robot;
  }

  /** Its robots, by name. */
  public List<SimulatedRobot> robots() {
    return List.copyOf(robots.values());
  }

  /** The true state, for reports and tests. */
  public GroundTruth groundTruth() {
    return new GroundTruth(this);
  }

  /**
   * Advances to a time, if it is later than the current one. Every query with a time does so
   * implicitly.
   */
  public void advanceTo(Instant time) {
    synchronized (monitor) {
      advance(time);
    }
  }

  /** The monitor that guards everything in a world. */
  Object monitor() {
    return monitor;
  }

  ObstacleIndex solids() {
    return solids;
  }

  List<VehicleBody> bodies() {
    return bodies;
  }

  CollisionDetector contacts() {
    return contacts;
  }

  /** The scene shared by all cameras; the caller must hold the monitor. */
  RenderScene renderScene() {
    RenderScene made = scene;
    if (made == null) {
      made = new RenderScene(this);
      scene = made;
    }
    return made;
  }

  /** Advances to a time and returns the step to use; the caller must hold the monitor. */
  long stepAt(Instant time) {
    advance(time);
    return history.clampStep(timeline.step(time));
  }

  /** The numbers of a step that {@link #stepAt} returned; the caller must hold the monitor. */
  double[] row(long step) {
    return history.row(step);
  }

  /** The time of a step. */
  Instant instant(long step) {
    return timeline.instant(step);
  }

  long lateCommands() {
    synchronized (monitor) {
      return lateCommands;
    }
  }

  /** Accepts a command, which takes effect from the first step after its time on. */
  void command(Instant time, Runnable command) {
    synchronized (monitor) {
      advance(time);
      if (timeline.step(time) < history.last()) {
        lateCommands++;
      }
      commands.add(command);
    }
  }

  private void advance(Instant time) {
    long requested = timeline.step(time);
    if ((requested - history.last()) * STEP_SECONDS > LONGEST_LEAP.getSeconds()) {
      throw new IllegalArgumentException(
          "the world is at "
              + instant(history.last())
              + " and cannot jump to "
              + time
              + ", more than "
              + LONGEST_LEAP.toDays()
              + " days later; correct the clock");
    }
    while (history.last() < requested) {
      long next = history.last() + 1;
      for (int i = 0; i < bodies.size(); i++) {
        bodies.get(i).step(next);
      }
      while (!commands.isEmpty()) {
        commands.remove().run();
      }
      write(history.append());
    }
  }

  private void write(double[] row) {
    for (int i = 0; i < bodies.size(); i++) {
      bodies.get(i).write(row);
    }
    for (int i = 0; i < heads.size(); i++) {
      heads.get(i).write(row);
    }
  }

  /**
   * Maps the steps of a world to time.
   *
   * @param start time of the first one, 0
   */
  private record Timeline(Instant start) {

    private static final long STEP_NANOS = World.STEP.toNanos();
    private static final long PER_SECOND = 1_000_000_000 / STEP_NANOS;

    /** The step that a time belongs to: the last one that is not after it; 0 before the start. */
    long step(Instant time) {
      if (time.isBefore(start)) {
        return 0;
      }
      Duration since = Duration.between(start, time);
      return since.getSeconds() * PER_SECOND + since.getNano() / STEP_NANOS;
    }

    /** The time of a step. */
    Instant instant(long step) {
      return start.plusNanos(step * STEP_NANOS);
    }
  }

  /**
   * The last steps of a world, a row of numbers each, so that late queries get the state of their
   * time. Confined to the world's monitor.
   */
  private static final class StateHistory {

    /** Number of steps stored. */
    static final int CAPACITY = CorrelatedNoise.REMEMBERED;

    private final double[][] rows;
    private long last;

    /**
     * @param width numbers in a row
     */
    StateHistory(int width) {
      rows = new double[CAPACITY][width];
    }

    /** The last step added; the first is 0. */
    long last() {
      return last;
    }

    /** Adds the row of the next step, to be filled. */
    double[] append() {
      last++;
      return rows[(int) (last % CAPACITY)];
    }

    /** The stored step nearest to the requested one. */
    long clampStep(long step) {
      return Math.max(Math.max(0, last - CAPACITY + 1), Math.min(step, last));
    }

    /** The row of a stored step. */
    double[] row(long step) {
      return rows[(int) (step % CAPACITY)];
    }
  }
}
