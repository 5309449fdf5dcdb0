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
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.noise.RandomStream;
import org.dfra.sim.world.shape.ObstacleIndex;
import org.dfra.sim.world.shape.StaticObstacle;
import org.jspecify.annotations.Nullable;

/**
 * A world in time. It goes on in steps of {@link #STEP} as soon as anybody asks for a later time,
 * and by itself never; between two steps it stands still.
 *
 * <p>Who asks for a time up to two seconds before the latest asked for is still told of that time;
 * before that, of the oldest time known. A command given for a time before the latest asked for
 * acts from the next step on, and is counted as late ({@link GroundTruth#lateCommands}). Where one
 * clock steps everybody, nobody is ever late, and the whole run repeats bit by bit.
 *
 * <p>Any thread may call; the world is one monitor.
 */
public final class World {

  /** From one step to the next. */
  public static final Duration STEP = Duration.ofMillis(10);

  static final double STEP_SECONDS = 0.01;

  /** A clock that jumps farther than this is wrong. */
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
  private @Nullable RenderScene gallery; // guarded by the monitor

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
   * Makes a world.
   *
   * @param start when its time begins; before that it is as at the start
   */
  public static World of(WorldDescription description, Instant start) {
    return new World(description, start);
  }

  private VehicleBody body(VehicleDescription vehicle, BodyContext around) {
    return vehicle.type() == VehicleType.UGV
        ? new SkidSteerBody(vehicle, bodies.size(), around)
        : MulticopterBody.of(vehicle, bodies.size(), around);
  }

  /** What it was made from. */
  public WorldDescription description() {
    return description;
  }

  /** When its time began. */
  public Instant start() {
    return timeline.start();
  }

  /** The world's frame on the earth: east, north and up from the datum. */
  public LocalFrame frame() {
    return frame;
  }

  /** The latest step that was asked for. */
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

  /** What no robot knows, for reports and tests. */
  public GroundTruth groundTruth() {
    return new GroundTruth(this);
  }

  /**
   * Lets it go on to a time, if it is not there yet. Everything that is asked with a time does so
   * by itself.
   */
  public void advanceTo(Instant time) {
    synchronized (monitor) {
      advance(time);
    }
  }

  /** What everything in a world is guarded by. */
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

  /** What all cameras share; the monitor must be held. */
  RenderScene renderScene() {
    RenderScene made = gallery;
    if (made == null) {
      made = new RenderScene(this);
      gallery = made;
    }
    return made;
  }

  /** Goes on to a time, and tells the step to answer for; the monitor must be held. */
  long stepAt(Instant time) {
    advance(time);
    return history.clampStep(timeline.step(time));
  }

  /** The numbers of a step that {@link #stepAt} told; the monitor must be held. */
  double[] row(long step) {
    return history.row(step);
  }

  /** When a step is. */
  Instant instant(long step) {
    return timeline.instant(step);
  }

  long lateCommands() {
    synchronized (monitor) {
      return lateCommands;
    }
  }

  /** Takes a command, which acts from the first step after its time on. */
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
              + " and was asked for "
              + time
              + ", more than "
              + LONGEST_LEAP.toDays()
              + " days later; set the clock right");
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
}
