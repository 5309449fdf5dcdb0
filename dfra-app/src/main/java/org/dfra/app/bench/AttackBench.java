package org.dfra.app.bench;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.dfra.app.bench.attack.AdministrativeCalls;
import org.dfra.app.bench.attack.AttackTask;
import org.dfra.app.bench.attack.AttackTask.Target;
import org.dfra.app.bench.attack.FakeModules;
import org.dfra.app.bench.attack.HashBombs;
import org.dfra.app.bench.attack.HonestRobot;
import org.dfra.app.bench.attack.ListenerFlood;
import org.dfra.app.bench.attack.NeutralLoad;
import org.dfra.app.bench.attack.Operator;
import org.dfra.app.bench.attack.ProcessSample;
import org.dfra.app.bench.attack.RogueAnnouncements;
import org.dfra.app.bench.attack.SlowHeaders;
import org.dfra.app.bench.attack.TaskProcess;
import org.dfra.app.bench.attack.UnfinishedRequests;

/**
 * What a stranger without a key can do to a robot that searches a field while an operator listens.
 * Every attack, and before them a neutral load, has a robot of its own:
 *
 * <pre>
 *   core 0               core 1
 *   attacker  --------&gt;  robot with its registrar, &lt;---- operator: calls, listens,
 *                        drivers, simulated field        falls silent, stops it
 * </pre>
 *
 * <p>Times of the wheels are those of the simulated field.
 */
final class AttackBench implements Bench {

  /** An attack and what it is called. */
  private record Attack(String name, Class<? extends AttackTask> task) {}

  private static final Attack NEUTRAL = new Attack("a neutral load", NeutralLoad.class);
  private static final List<Attack> ATTACKS =
      List.of(
          new Attack("fake modules", FakeModules.class),
          new Attack("hash bombs", HashBombs.class),
          new Attack("unfinished requests", UnfinishedRequests.class),
          new Attack("a flood of listeners", ListenerFlood.class),
          new Attack("rogue announcements", RogueAnnouncements.class),
          new Attack("slow headers", SlowHeaders.class),
          new Attack("administrative calls", AdministrativeCalls.class));

  /**
   * What was measured beside a load.
   *
   * @param p99 of honest calls, milliseconds
   * @param failed honest calls
   * @param cpu seconds of the robot's CPU time while the operator listened
   * @param threads more than before the load
   * @param heap bytes more than before the load
   * @param slower seconds from the operator's last command until the wheels became slower
   * @param silent seconds from the operator's last command until they stopped
   * @param stopped seconds from the emergency stop until they stopped
   * @param recovered seconds until the robot uses what it used before
   * @param calls of the attacker, and how many of them were refused
   */
  private record Result(
      double p99,
      int failed,
      double cpu,
      int threads,
      long heap,
      double slower,
      double silent,
      double stopped,
      double recovered,
      long calls,
      long refused) {}

  private static final String ATTACKER = "127.0.0.66";
  private static final String ROBOT = "127.0.0.1";
  private static final Duration START = Duration.ofMinutes(3);
  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final Duration RECOVERY = Duration.ofSeconds(10);
  private static final Duration QUIET = Duration.ofSeconds(1); // so long: they have stopped

  private static final Duration LOOK_AGAIN = Duration.ofMillis(50);

  private static final double MOST_SLOWER = 0.35; // s: 0.3, and 10 % of the speed to be lost
  private static final double MOST_STOPPED = 0.5; // s
  private static final double MOST_RATIO = 3;
  private static final int MOST_THREADS = 64;
  private static final double MEGABYTE = 1 << 20;
  private static final double MOST_MEGABYTES = 8;
  private static final double MOST_CPU = 1; // s for each refused call

  private final int seconds;

  /**
   * @param seconds how long each attack lasts before the wheels are measured, at least 1
   */
  AttackBench(int seconds) {
    this.seconds = seconds;
  }

  @Override
  public void run(Report report) throws Exception {
    boolean pinned = canPin();
    String source = source();
    report.say(
        pinned
            ? "The attacker runs on core 0, robot and operator on core 1."
            : "Not pinned: this computer has no taskset, or one core. The figures count the"
                + " scheduler's choices too.");
    if (!source.equals(ATTACKER)) {
      report.say(
          "The attacker calls from the robot's own address: this computer has no other loopback"
              + " address. What is refused by address is not refused here.");
    }
    Result neutral = measure(report, NEUTRAL, source, pinned);
    report.figure("p99 of honest calls beside " + NEUTRAL.name(), neutral.p99(), "ms");
    wheels(report, NEUTRAL, neutral);
    for (Attack each : ATTACKS) {
      try {
        judge(report, each, measure(report, each, source, pinned), neutral);
      } catch (IOException e) { // the others are measured all the same
        report.say("  not measured: " + e.getMessage());
        report.figure("robot or operator failed beside " + each.name(), 1, 0, "");
      }
    }
  }

  /** Another address than the robot's, where there is one. */
  private static String source() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(ATTACKER))) {
      return socket.isBound() ? ATTACKER : ROBOT;
    } catch (BindException e) { // macOS has 127.0.0.1 only
      return ROBOT;
    }
  }

  private static boolean canPin() {
    String path = System.getenv().getOrDefault("PATH", "");
    return Runtime.getRuntime().availableProcessors() > 1
        && Stream.of(path.split(":"))
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, "taskset")));
  }

  private static List<String> onCore(int core, boolean pinned) {
    return pinned ? List.of("taskset", "-c", Integer.toString(core)) : List.of();
  }

  private Result measure(Report report, Attack attack, String source, boolean pinned)
      throws Exception {
    report.say(seconds + " s of " + attack.name() + " …");
    List<String> root = List.of("-Ddfra.root=" + System.getProperty("dfra.root", "."));
    List<String> heap = new ArrayList<>(root);
    heap.add("-Xmx256m");
    try (TaskProcess robot = TaskProcess.start(onCore(1, pinned), heap, HonestRobot.class)) {
      String[] ports = robot.awaitLine("registrar", START).split(" ");
      Target target =
          new Target(source, ROBOT, Integer.parseInt(ports[1]), Integer.parseInt(ports[3]));
      try (TaskProcess operator =
          TaskProcess.start(onCore(1, pinned), root, Operator.class, ports[1])) {
        String unused = operator.awaitLine("drives", START);
        ProcessSample before = ProcessSample.of(robot.pid());
        try (TaskProcess attacker =
            TaskProcess.start(onCore(0, pinned), root, attack.task(), target.arguments())) {
          String unusedEither = attacker.awaitLine("begins", START);
          return measure(robot, operator, attacker, before);
        }
      }
    }
  }

  private Result measure(
      TaskProcess robot, TaskProcess operator, TaskProcess attacker, ProcessSample before)
      throws Exception {
    Duration cpu = ProcessSample.cpu(robot.pid());
    operator.write("listen " + seconds);
    String[] calls = operator.awaitLine("calls", PATIENCE.plusSeconds(seconds)).split(" ");
    double busy = ProcessSample.cpu(robot.pid()).minus(cpu).toMillis() / 1e3;
    ProcessSample during = ProcessSample.of(robot.pid());

    operator.write("fall silent");
    long silence = micros(operator.awaitLine("silent", PATIENCE));
    String[] silent = awaitStopped(robot, silence);
    operator.write("stop");
    long order = micros(operator.awaitLine("stopped", PATIENCE));
    String[] stopped = awaitStopped(robot, order);

    attacker.write("stop");
    String[] done = attacker.awaitLine("done", PATIENCE).split(" ", 4);
    attacker.close();
    return new Result(
        Long.parseLong(calls[4]) / 1e3,
        Integer.parseInt(calls[2]),
        busy,
        during.threads() - before.threads(),
        during.heapBytes() - before.heapBytes(),
        (Long.parseLong(silent[2]) - silence) / 1e6,
        (Long.parseLong(silent[1]) - silence) / 1e6,
        Math.max(0, Long.parseLong(stopped[1]) - order) / 1e6,
        recovery(robot, before),
        Long.parseLong(done[1]),
        Long.parseLong(done[2]));
  }

  private static long micros(String line) {
    return Long.parseLong(line.split(" ")[1]);
  }

  /** The wheels' line once they have not moved for a while. */
  private static String[] awaitStopped(TaskProcess robot, long since) throws Exception {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (System.nanoTime() < end) {
      robot.write("");
      String[] wheels = robot.awaitLine("wheels", PATIENCE).split(" ");
      long last = Math.max(since, Long.parseLong(wheels[1]));
      long quiet = ChronoUnit.MICROS.between(Instant.EPOCH, Instant.now()) - last;
      if (quiet > QUIET.toNanos() / 1000) {
        return wheels;
      }
      LockSupport.parkNanos(LOOK_AGAIN.toNanos()); // the wheels report nothing by themselves
    }
    throw new IOException("the wheels did not stop within " + PATIENCE.toSeconds() + " s");
  }

  /** Seconds until threads and heap are within the limits again; infinite if they stay above. */
  private static double recovery(TaskProcess robot, ProcessSample before) throws Exception {
    long began = System.nanoTime();
    while (true) {
      ProcessSample now = ProcessSample.of(robot.pid());
      double after = (System.nanoTime() - began) / 1e9;
      if (now.threads() - before.threads() <= MOST_THREADS
          && now.heapBytes() - before.heapBytes() <= MOST_MEGABYTES * MEGABYTE) {
        return after;
      }
      if (after > 2 * RECOVERY.toSeconds()) {
        return Double.POSITIVE_INFINITY;
      }
    }
  }

  private static void judge(Report report, Attack attack, Result result, Result neutral) {
    String beside = " beside " + attack.name();
    report.say(
        "  %d calls of the attacker, %d refused; %d honest calls failed"
            .formatted(result.calls(), result.refused(), result.failed()));
    wheels(report, attack, result);
    report.figure(
        "p99 of honest calls" + beside + ", times that beside " + NEUTRAL.name(),
        result.p99() / neutral.p99(),
        MOST_RATIO,
        "");
    report.figure("threads added" + beside, result.threads(), MOST_THREADS, "");
    report.figure("heap added" + beside, result.heap() / MEGABYTE, MOST_MEGABYTES, "MB");
    if (result.refused() > 0) {
      double more = Math.max(0, result.cpu() - neutral.cpu());
      report.figure("CPU for each refused call" + beside, more / result.refused(), MOST_CPU, "s");
    }
    report.figure(
        "back to normal after " + attack.name(), result.recovered(), RECOVERY.toSeconds(), "s");
  }

  private static void wheels(Report report, Attack attack, Result result) {
    String beside = " beside " + attack.name();
    report.figure(
        "wheels slower after the last command" + beside, result.slower(), MOST_SLOWER, "s");
    report.figure(
        "wheels stopped after the last command" + beside, result.silent(), MOST_STOPPED, "s");
    report.figure(
        "wheels stopped after the emergency stop" + beside, result.stopped(), MOST_STOPPED, "s");
  }
}
