package org.dfra.behaviors.perceptual.team;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.dfra.behaviors.ScriptedRobot;
import org.dfra.behaviors.ScriptedSensors.Receiver;
import org.dfra.behaviors.ScriptedSensors.Wheels;
import org.dfra.behaviors.SteppedTime;
import org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.flow.sensor.GpsFix;

/**
 * A robot that drives along a line from west to east or back, with a clock of its own: wheels at 10
 * Hz, a receiver at 1 Hz whose fixes come late, and a real position estimator and team tracker.
 */
final class Searcher implements AutoCloseable {

  private static final double LEAST_LATENCY = 0.16; // seconds
  private static final double MORE_LATENCY = 0.02; // seconds, the mean of what is on top
  private static final double TICK = 0.1;

  final String name;
  final OwnTime time;
  final PositionEstimatorImpl position;
  final TeamTrackerImpl team;

  private final SteppedTime truth;
  private final InMemoryModuleDirectory directory;
  private final SplittableRandom random;
  private final double from;
  private final double speed;
  private final Wheels wheels;
  private final Receiver receiver;
  private final Map<ModuleImpl, DirectoryRegistration> listed = new HashMap<>();
  private long ticks;

  /**
   * @param from where it begins, metres east of the datum
   * @param speed metres per second to the east, − is to the west
   */
  Searcher(
      String name,
      SteppedTime truth,
      OwnTime time,
      InMemoryModuleDirectory directory,
      long seed,
      double from,
      double speed) {
    this.name = name;
    this.truth = truth;
    this.time = time;
    this.directory = directory;
    this.random = new SplittableRandom(seed);
    this.from = from;
    this.speed = speed;
    this.wheels = add(new Wheels(context("odometry", Map.of())));
    this.receiver = add(new Receiver(context("gps_front", Map.of())));
    String yaw = speed < 0 ? "3.14159" : "0";
    this.position =
        add(
            new PositionEstimatorImpl(
                context(
                    "position",
                    Map.of("datum", "48 11", "gps_bias_sigma", "0", "initial_yaw", yaw))));
    this.team = add(new TeamTrackerImpl(context("team", Map.of())));
    tick();
  }

  private ModuleContext context(String module, Map<String, String> parameters) {
    return new ModuleContext(
            name,
            module,
            Parameters.of(name + "/" + module, parameters),
            time,
            StateStore.inMemory())
        .withDirectory(directory);
  }

  private <M extends ModuleImpl> M add(M module) {
    module.start();
    listed.put(module, directory.add(module));
    return module;
  }

  /** Nobody finds that module from now on, and its subscriptions end. */
  void end(ModuleImpl module) {
    listed.remove(module).close();
    module.close();
  }

  /** Where it truly is, metres east of the datum. */
  double east() {
    return from + speed * truth.nanos() / 1e9;
  }

  private void tick() {
    wheels.count(Math.abs(east() - from), Math.abs(speed));
    if (ticks++ % 10 == 0) {
      solve();
    }
    Object unused = truth.after(Math.round(TICK * 1e9), this::tick);
  }

  /** The receiver knows where it is now, and tells it later. */
  private void solve() {
    GpsFix fix =
        new GpsFix(
            GpsFix.Mode.FIX_3D,
            ScriptedRobot.at(east(), 0),
            truth.instant(), // satellites know the true time
            Math.abs(speed),
            speed < 0 ? 270 : 90,
            1,
            9,
            9);
    double latency = LEAST_LATENCY - MORE_LATENCY * Math.log(1 - random.nextDouble());
    Object unused = truth.after(Math.round(latency * 1e9), () -> receiver.solve(fix));
  }

  @Override
  public void close() {
    List.copyOf(listed.keySet()).forEach(this::end);
  }
}
