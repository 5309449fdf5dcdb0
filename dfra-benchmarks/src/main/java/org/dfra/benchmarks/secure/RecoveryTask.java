package org.dfra.benchmarks.secure;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dfra.benchmarks.task.Task;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/**
 * A robot of {@code ./dfra demo persona}, open or secure, whose processes are killed and suspended.
 * The client is a process of the same robot.
 */
public final class RecoveryTask implements Task {

  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final String ROBOT = "atrv1";
  private static final String RECEIVER = "gps_front";
  private static final String OPEN = "open";
  private static final String SECURE = "secure";
  private static final double NANOS = 1e9;

  /** For {@link TaskProcess}. */
  public RecoveryTask() {}

  /** What is measured. */
  public enum Recovery {
    /** From the command to start the robot until a client has called both receivers. */
    START("start of a robot to its receivers' first answers"),
    /** From {@code kill -9} of a receiver's group until the next call is answered. */
    KILLED_GROUP("killed group to next call answered"),
    /** From the continuation of a suspended group, whose silence was reported, until it answers. */
    SUSPENDED_GROUP("continued group to next call answered"),
    /** From the start of phoenix, after {@code kill -9}, until it answers. */
    KILLED_PHOENIX("phoenix's restart to its first answer"),
    /** The same as the first kill, with a phoenix that has adopted the group. */
    ADOPTED_GROUP("killed group to next call answered, after phoenix's restart"),
    /** From {@code kill -9} of the registrar until a client that comes then has called a module. */
    KILLED_REGISTRAR("killed registrar to a new client's first answer");

    private final String label;

    Recovery(String label) {
      this.label = label;
    }

    /** Its name in tables and records. */
    public String label() {
      return label;
    }
  }

  /**
   * Measures in a process of its own.
   *
   * @param links to two receivers that send a position each second
   * @return seconds
   */
  public static Map<Recovery, Double> measure(boolean isSecure, List<String> links)
      throws Exception {
    Map<Recovery, Double> measured = new EnumMap<>(Recovery.class);
    try (TaskProcess process =
        TaskProcess.start(
            List.of(),
            List.of("-Ddfra.root=" + System.getProperty("dfra.root", "")),
            RecoveryTask.class,
            isSecure ? SECURE : OPEN,
            links.get(0),
            links.get(1))) {
      for (Recovery each : Recovery.values()) {
        String[] words = process.awaitLine(each.name() + " ", PATIENCE).split(" ");
        measured.put(each, Double.parseDouble(words[1]));
      }
      int unused = process.awaitEnd(PATIENCE);
    }
    return measured;
  }

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    try (DemoEnvironment environment = new DemoEnvironment()) {
      DemoRobot robot =
          DemoRobot.of(environment, "field", ROBOT, Map.of(RECEIVER, args[1], "gps_rear", args[2]));
      if (args[0].equals(SECURE)) {
        Path state = robot.host().phoenix().state();
        try (BenchTeam team = BenchTeam.create(environment.folder().resolve("authority"))) {
          BenchTeam.install(team.join(state, MemberRole.ROBOT, ROBOT));
        }
      }
      measure(environment, robot, out);
      environment.shutDown();
    }
  }

  private static void measure(DemoEnvironment environment, DemoRobot robot, PrintStream out)
      throws Exception {
    long began = System.nanoTime();
    Object unused = robot.bringUp();
    try (ModuleDirectory directory = directory(robot)) {
      GPSSensor gps = module(directory, RECEIVER);
      Object unusedToo = module(directory, "gps_rear").readiness();
      Object unusedThree = gps.readiness();
      report(out, Recovery.START, secondsSince(began));
      report(out, Recovery.KILLED_GROUP, killed(environment, robot, gps));
      report(out, Recovery.SUSPENDED_GROUP, suspended(environment, robot, gps));
      robot.host().killPhoenix();
      long restarted = System.nanoTime();
      ProcessHandle unusedFour = robot.host().startPhoenix();
      report(out, Recovery.KILLED_PHOENIX, secondsSince(restarted));
      report(out, Recovery.ADOPTED_GROUP, killed(environment, robot, gps));
    }
    long registrar = robot.process("lookup");
    long killed = System.nanoTime();
    environment.signal("KILL", registrar);
    try (ModuleDirectory directory = directory(robot)) {
      Object unusedFive = module(directory, RECEIVER).readiness();
      report(out, Recovery.KILLED_REGISTRAR, secondsSince(killed));
    }
  }

  private static void report(PrintStream out, Recovery what, double seconds) {
    out.printf(Locale.ROOT, "%s %.4f%n", what.name(), seconds);
  }

  private static double secondsSince(long began) {
    return (System.nanoTime() - began) / NANOS;
  }

  private static ModuleDirectory directory(DemoRobot robot) throws IOException {
    return new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), List.of(robot.locator()));
  }

  private static GPSSensor module(ModuleDirectory directory, String name)
      throws IOException, InterruptedException {
    return directory
        .findFirst(
            ModuleQuery.of(GPSSensor.class).robot(ROBOT).name(name), DemoEnvironment.PATIENCE)
        .map(ModuleListing::module)
        .orElseThrow(() -> new IOException(name + " was not found"));
  }

  /** Returns the seconds until it answered. */
  private static double killed(DemoEnvironment environment, DemoRobot robot, GPSSensor gps)
      throws Exception {
    long process = robot.process(RECEIVER);
    long began = System.nanoTime();
    environment.signal("KILL", process);
    answer(gps);
    double seconds = secondsSince(began);
    if (robot.process(RECEIVER) == process) {
      throw new IOException("process " + process + " still runs");
    }
    return seconds;
  }

  private static double suspended(DemoEnvironment environment, DemoRobot robot, GPSSensor gps)
      throws Exception {
    long process = robot.process(RECEIVER);
    environment.signal("STOP", process);
    DemoAssertions.await(
        "the suspension of process " + process,
        DemoEnvironment.PATIENCE,
        () -> isSuspended(process)); // a signal takes a moment
    @Nullable RemoteException silence = null;
    try {
      Object unused = gps.readiness();
    } catch (RemoteException e) {
      silence = e;
    }
    long began = System.nanoTime();
    environment.signal("CONT", process);
    if (silence == null) {
      throw new IOException("process " + process + " was suspended, and has answered");
    }
    answer(gps);
    return secondsSince(began);
  }

  /** See proc(5): the state follows the name, which is in parentheses. */
  private static boolean isSuspended(long process) throws IOException {
    String state = Files.readString(Path.of("/proc", Long.toString(process), "stat"));
    return state.startsWith("T", state.lastIndexOf(')') + 2);
  }

  private static void answer(GPSSensor gps) throws IOException {
    long end = System.nanoTime() + DemoEnvironment.PATIENCE.toNanos();
    while (true) {
      try {
        Object unused = gps.readiness();
        return;
      } catch (RemoteException e) {
        if (System.nanoTime() - end > 0) {
          throw e;
        }
      }
    }
  }
}
