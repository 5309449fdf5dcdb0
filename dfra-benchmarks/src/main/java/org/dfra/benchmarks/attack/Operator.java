package org.dfra.benchmarks.attack;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.behavior.RasterGoal;
import org.dfra.behavior.RasterSearch;
import org.dfra.benchmarks.task.Task;
import org.dfra.core.host.CommandName;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.jspecify.annotations.Nullable;

/**
 * The operator of an {@link HonestRobot}: starts its search, subscribes to it, and executes the
 * commands on its input:
 *
 * <pre>
 *   listen SECONDS  calls the drive for this time: "calls COUNT FAILED P50 P99 RECEIVED", the
 *                   latencies in microseconds
 *   fall silent     ends the search, drives on, and then sends no more commands: "silent TIME"
 *   stop            drives on, and then stops the robot for an emergency: "stopped TIME"
 * </pre>
 *
 * Times are microseconds since the epoch; {@code listen} must precede the other two.
 */
public final class Operator implements Task {

  private static final Duration PATIENCE = Duration.ofSeconds(90);
  private static final Duration LEASE = Duration.ofSeconds(10);
  private static final Duration DRIVE = Duration.ofSeconds(2);
  private static final long PERIOD_MILLIS = 20;
  private static final double SWATH = 2.5; // metres
  private static final double SPACING = 2; // metres
  private static final Path WORLD =
      Path.of(System.getProperty("dfra.root", "."), "config", "worlds", "raster.xml");

  private @Nullable CommandLease lease;

  /** Called by {@code TaskMain} by reflection. */
  public Operator() {}

  /** Argument: the registrar's port. */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    String locator = "jini://" + HonestRobot.HOST + ":" + args[0];
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(HonestRobot.HOST, List.of(), List.of(locator))) {
      RasterSearch search = find(directory, RasterSearch.class);
      DriveEffector drive = find(directory, DriveEffector.class);
      begin(search);
      try (Subscription listening =
          search.subscribe(event -> {}, DeliveryPolicy.keepLast(10).withKinds(EventKind.READING))) {
        out.println("drives");
        BufferedReader in =
            new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line; (line = in.readLine()) != null; ) {
          out.println(answer(line, search, drive, listening));
        }
      }
    }
  }

  private static <M extends Module> M find(JiniModuleDirectory directory, Class<M> kind)
      throws Exception {
    return directory
        .findFirst(ModuleQuery.of(kind).robot(HonestRobot.NAME), PATIENCE)
        .orElseThrow(() -> new IOException(HonestRobot.NAME + " has no " + kind.getSimpleName()))
        .module();
  }

  /** Modules become ready one after the other, and refuse goals until then. */
  private static void begin(RasterSearch search) throws Exception {
    WorldDescription world = WorldXml.read(WORLD);
    LocalFrame frame = new LocalFrame(world.datum());
    List<GeoPosition> corners = new ArrayList<>();
    for (Vertex each : world.region().orElseThrow().corners()) {
      corners.add(frame.toGeo(new LocalPosition(each.east(), each.north(), 0)));
    }
    RasterGoal goal = new RasterGoal(corners, SWATH, SPACING, false);
    String robot = HonestRobot.NAME;
    DemoAssertions.await(
        "that " + robot + " is ready", PATIENCE, () -> search.readiness().serves());
    var unused = search.pursue(goal);
    DemoAssertions.await(
        "that " + robot + " searches", PATIENCE, () -> search.status().phase().isUnderWay());
  }

  private String answer(
      String line, RasterSearch search, DriveEffector drive, Subscription listening)
      throws Exception {
    if (line.startsWith("listen ")) {
      return listen(Integer.parseInt(line.substring("listen ".length())), drive, listening);
    }
    if (line.equals("fall silent")) {
      search.cancel();
      CommandLease held = command(drive);
      lease = held; // long, so that the command timeout ends the driving and not the lease
      return "silent " + HonestRobot.micros(driveOn(drive, held));
    }
    if (line.equals("stop")) {
      CommandLease held = lease;
      if (held == null) {
        throw new IllegalStateException("the operator falls silent before it stops the robot");
      }
      Instant last = driveOn(drive, held);
      Instant ordered = Instant.now();
      var unused = drive.emergencyStop(CommandName.current() + " bench attack");
      held.close();
      return "stopped " + HonestRobot.micros(ordered.isAfter(last) ? ordered : last);
    }
    throw new IllegalArgumentException(line);
  }

  private static String listen(int seconds, DriveEffector drive, Subscription listening) {
    List<Double> latencies = new ArrayList<>();
    int failed = 0;
    long received = listening.received();
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (System.nanoTime() < end) {
      long began = System.nanoTime();
      try {
        var unused = drive.driveState();
      } catch (RemoteException | NotReadyException e) { // counted, with the time it took
        failed++;
      }
      latencies.add((System.nanoTime() - began) / 1e3);
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(PERIOD_MILLIS));
    }
    double[] sorted = latencies.stream().mapToDouble(Double::doubleValue).sorted().toArray();
    return "calls %d %d %d %d %d"
        .formatted(
            sorted.length,
            failed,
            Math.round(sorted[sorted.length / 2]),
            Math.round(sorted[sorted.length * 99 / 100]),
            listening.received() - received);
  }

  /** The search releases its command lease soon after it was cancelled. */
  private static CommandLease command(DriveEffector drive) throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (true) {
      try {
        return drive.acquireCommandLease(LEASE);
      } catch (LeaseRefusedException e) {
        if (System.nanoTime() - end > 0) {
          throw e;
        }
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(PERIOD_MILLIS));
      }
    }
  }

  /**
   * Drives on for a while and returns the time of the last acknowledged command. An unanswered
   * command is repeated by the next one.
   */
  private static Instant driveOn(DriveEffector drive, CommandLease held) throws Exception {
    drive.execute(held.key(), new Brake(false));
    Instant end = Instant.now().plus(DRIVE);
    Instant last = Instant.now();
    while (Instant.now().isBefore(end)) {
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(PERIOD_MILLIS));
      Instant sent = Instant.now();
      try {
        drive.execute(held.key(), new Velocity(HonestRobot.CRUISE, 0));
        last = sent;
      } catch (RemoteException e) {
        System.err.println("a command was not answered: " + e);
      }
    }
    return last;
  }
}
