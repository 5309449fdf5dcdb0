package org.dfra.benchmarks;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.dfra.benchmarks.attack.AttackCase;
import org.dfra.benchmarks.attack.AttackCase.Attacker;
import org.dfra.benchmarks.attack.AttackTask.Target;
import org.dfra.benchmarks.attack.HonestRobot;
import org.dfra.benchmarks.attack.LocalMulticast;
import org.dfra.benchmarks.attack.MeasuredValueLines;
import org.dfra.benchmarks.attack.Operator;
import org.dfra.benchmarks.attack.OtherUser;
import org.dfra.benchmarks.attack.ProcessSample;
import org.dfra.benchmarks.task.TaskProcess;
import org.dfra.report.measurement.MeasuredValue;
import org.jspecify.annotations.Nullable;

/**
 * Measures what an unauthenticated client can do to a robot that searches a field while an operator
 * receives its events. Each attack, and the neutral load before them, uses a new robot:
 *
 * <pre>
 *   core 0               core 1
 *   attacker  --------&gt;  robot with its registrar, &lt;---- operator: calls it, stops
 *                        drivers, simulated field        commanding, stops it
 *             --------&gt;  its phoenix, if that is attacked
 * </pre>
 *
 * <p>Wheel times are measured in the simulated field. The number of threads is the maximum during
 * the attack. Threads, heap and CPU time are those of the robot and its phoenix.
 */
final class AttackBench implements Bench {

  private static final String ATTACKER = "127.0.0.66";
  private static final String ROBOT = "127.0.0.1";
  private static final Duration START = Duration.ofMinutes(3);
  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final Duration QUIET = Duration.ofSeconds(1); // then the wheels have stopped

  /** So long the number of threads does not change: the processes have started. */
  private static final Duration SETTLED = Duration.ofSeconds(3);

  private static final Duration SAMPLE_INTERVAL = Duration.ofMillis(500);
  private static final Duration LOOK_AGAIN = Duration.ofMillis(50);

  private final int seconds;

  /**
   * The setup in which attacks are measured.
   *
   * @param source source address of the attacker's calls
   * @param isPinned whether attacker and robot are pinned to one core each
   * @param user another user of this computer; null if processes of other users cannot be started
   * @param hasMulticast whether this computer receives its own multicast
   * @param folder a temporary folder
   */
  private record AttackSetup(
      String source,
      boolean isPinned,
      @Nullable OtherUser user,
      boolean hasMulticast,
      Path folder) {

    List<String> onCore(int core) {
      return isPinned ? List.of("taskset", "-c", Integer.toString(core)) : List.of();
    }

    /** Why an attack cannot be run here; empty if it can. */
    String missing(AttackCase attack) {
      if (attack.attacker() == Attacker.LOCAL_USER && user == null) {
        return OtherUser.NEEDS;
      }
      return attack.isByMulticast() && !hasMulticast ? LocalMulticast.NEEDS : "";
    }

    /** The user that runs the attacker's process; null for this process's own user. */
    @Nullable OtherUser user(AttackCase attack) {
      return attack.attacker() == Attacker.STRANGER ? null : user;
    }
  }

  /**
   * @param seconds duration of each attack before the wheels are measured, at least 1
   */
  AttackBench(int seconds) {
    this.seconds = seconds;
  }

  @Override
  public void run(Report report) throws Exception {
    Path folder = Files.createTempDirectory("dfra-attack-");
    try {
      @Nullable OtherUser user =
          OtherUser.find(Files.createDirectory(folder.resolve("classes"))).orElse(null);
      run(report, new AttackSetup(source(), canPin(), user, LocalMulticast.isPossible(), folder));
    } finally {
      delete(folder, report);
    }
  }

  private void run(Report report, AttackSetup place) throws Exception {
    report.say(
        place.isPinned()
            ? "The attacker runs on core 0, robot and operator on core 1."
            : "Not pinned: this computer has no taskset, or one core. The figures count the"
                + " scheduler's choices too.");
    if (!place.source().equals(ATTACKER)) {
      report.say(
          "The attacker calls from the robot's own address: this computer has no other loopback"
              + " address. What is refused by address is not refused here.");
    }
    AttackResult neutral = measure(report, AttackCase.BASELINE, place);
    neutral.report(report, AttackCase.BASELINE);
    for (AttackCase each : AttackCase.ALL) {
      String missing = place.missing(each);
      if (!missing.isEmpty()) {
        report.say("skipped: " + each.name() + " needs " + missing);
        continue;
      }
      try {
        measure(report, each, place).report(report, each, neutral);
      } catch (IOException e) { // the other attacks are still measured
        report.say("  not measured: " + e.getMessage());
        report.figure("robot, operator or attacker failed beside " + each.name(), 1, 0, "");
      }
    }
  }

  /** An address of this computer that differs from the robot's, if there is one. */
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

  private AttackResult measure(Report report, AttackCase attack, AttackSetup place)
      throws Exception {
    report.say(seconds + " s of " + attack.name() + " …");
    if (attack.attacker() == Attacker.LOCAL_USER_OR_STRANGER && place.user() == null) {
      report.say(
          "  skipped: as a user of the robot's computer it needs "
              + OtherUser.NEEDS
              + "; a stranger does it instead");
    }
    List<String> root = List.of("-Ddfra.root=" + System.getProperty("dfra.root", "."));
    List<String> limits = new ArrayList<>(root);
    limits.addAll(List.of("-Xmx256m", "-XX:+ExitOnOutOfMemoryError"));
    try (TaskProcess robot =
        TaskProcess.start(
            place.onCore(1), limits, HonestRobot.class, robotArguments(attack, place))) {
      List<Long> victims = new ArrayList<>(List.of(robot.pid()));
      int phoenixPort = 0;
      Path groupLock = Path.of("");
      if (attack.isOnPhoenix()) {
        String[] phoenix = robot.awaitLine("phoenix", START).split(" ");
        phoenixPort = Integer.parseInt(phoenix[1]);
        victims.add(Long.parseLong(phoenix[2]));
        robot.killWithThis(victims.get(1));
        groupLock = Path.of(robot.awaitLine("lock ", START).substring("lock ".length()));
      }
      String[] ports = robot.awaitLine("registrar", START).split(" ");
      Target target =
          new Target(
              place.user(attack) == null ? place.source() : ROBOT,
              ROBOT,
              Integer.parseInt(ports[1]),
              Integer.parseInt(ports[3]),
              phoenixPort,
              groupLock,
              attackersFolder(place));
      try (TaskProcess operator =
          TaskProcess.start(place.onCore(1), root, Operator.class, ports[1])) {
        String unused = operator.awaitLine("drives", START);
        ThreadCounter.Source threads = ThreadCounter.Source.of(victims);
        if (!ThreadCounter.awaitSettled(threads, SETTLED, SAMPLE_INTERVAL, PATIENCE)) {
          report.say("  The number of threads still changed before the attack; see \"threads\".");
        }
        ProcessSample before = ProcessSample.of(victims);
        int groups = groups(robot, attack);
        try (TaskProcess attacker = start(attack, place, root, target)) {
          String unusedEither = attacker.awaitLine("begins", START);
          try (ThreadCounter counter = ThreadCounter.start(threads, SAMPLE_INTERVAL)) {
            return measure(
                new RunningAttack(
                    attack, robot, operator, attacker, victims, before, groups, counter));
          }
        }
      }
    }
  }

  private static String[] robotArguments(AttackCase attack, AttackSetup place) throws IOException {
    List<String> arguments = new ArrayList<>();
    if (attack.isByMulticast()) {
      arguments.add(HonestRobot.SEARCH);
    }
    if (attack.isOnPhoenix()) {
      arguments.add(HonestRobot.PHOENIX + Files.createTempDirectory(place.folder(), "phoenix-"));
    }
    return arguments.toArray(String[]::new);
  }

  /** A folder that all users may write to. */
  private static Path attackersFolder(AttackSetup place) throws IOException {
    Path folder = Files.createTempDirectory(place.folder(), "attacker-");
    if (place.user() != null) {
      OtherUser.share(folder);
    }
    return folder;
  }

  private static TaskProcess start(
      AttackCase attack, AttackSetup place, List<String> options, Target target)
      throws IOException {
    @Nullable OtherUser user = place.user(attack);
    return user == null
        ? TaskProcess.start(place.onCore(0), options, attack.task(), target.arguments())
        : user.start(place.onCore(0), attack.task(), target.arguments());
  }

  /** A running attack, and the state of the attacked processes before it. */
  private record RunningAttack(
      AttackCase attack,
      TaskProcess robot,
      TaskProcess operator,
      TaskProcess attacker,
      List<Long> victims,
      ProcessSample before,
      int groups,
      ThreadCounter threads) {}

  private AttackResult measure(RunningAttack scene) throws Exception {
    TaskProcess robot = scene.robot();
    TaskProcess operator = scene.operator();
    Duration cpu = ProcessSample.cpu(scene.victims());
    operator.write("listen " + seconds);
    String[] calls = operator.awaitLine("calls", PATIENCE.plusSeconds(seconds)).split(" ");
    double busy = ProcessSample.cpu(scene.victims()).minus(cpu).toMillis() / 1e3;
    long heap = ProcessSample.of(scene.victims()).heapBytes();

    operator.write("fall silent");
    long silence = micros(operator.awaitLine("silent", PATIENCE));
    String[] silent = awaitStopped(robot, silence);
    operator.write("stop");
    long order = micros(operator.awaitLine("stopped", PATIENCE));
    String[] stopped = awaitStopped(robot, order);

    int threads = scene.threads().maximum();
    TaskProcess attacker = scene.attacker();
    attacker.write("stop");
    String[] done = attacker.awaitLine("done", PATIENCE).split(" ", 4);
    List<MeasuredValue> own = new ArrayList<>(MeasuredValueLines.read(attacker.lines()));
    attacker.close();
    double recovered = recovery(scene);
    if (scene.attack().isOnPhoenix()) {
      int more = groups(robot, scene.attack()) - scene.groups();
      own.add(new MeasuredValue("groups added at phoenix", more, 0, ""));
    }
    return new AttackResult(
        Long.parseLong(calls[4]) / 1e3,
        Integer.parseInt(calls[2]),
        busy,
        threads - scene.before().threads(),
        heap - scene.before().heapBytes(),
        (Long.parseLong(silent[3]) - silence) / 1e6,
        (Long.parseLong(silent[2]) - silence) / 1e6,
        (Long.parseLong(silent[1]) - silence) / 1e6,
        Math.max(0, Long.parseLong(stopped[1]) - order) / 1e6,
        recovered,
        Long.parseLong(done[1]),
        Long.parseLong(done[2]),
        own);
  }

  private static long micros(String line) {
    return Long.parseLong(line.split(" ")[1]);
  }

  /** Number of groups of the robot's phoenix; 0 if it has no phoenix. */
  private static int groups(TaskProcess robot, AttackCase attack) throws Exception {
    if (!attack.isOnPhoenix()) {
      return 0;
    }
    robot.write(HonestRobot.GROUPS);
    return Integer.parseInt(robot.awaitLine("groups", PATIENCE).split(" ")[1]);
  }

  /** The wheels' status line once they have not moved for a while. */
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
      LockSupport.parkNanos(LOOK_AGAIN.toNanos()); // the wheels must be polled
    }
    throw new IOException("the wheels did not stop within " + PATIENCE.toSeconds() + " s");
  }

  /**
   * Seconds until threads and heap are within the limits again; if they stay above, the timeout,
   * which exceeds the allowed time.
   */
  private static double recovery(RunningAttack scene) throws Exception {
    long began = System.nanoTime();
    while (true) {
      ProcessSample now = ProcessSample.of(scene.victims());
      double after = (System.nanoTime() - began) / 1e9;
      if (AttackResult.isNormal(now, scene.before())
          || after > 2 * AttackResult.RECOVERY.toSeconds()) {
        return after;
      }
    }
  }

  /** Ignores files that cannot be deleted: the measured values matter more than the folder. */
  private static void delete(Path folder, Report report) {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(each);
      }
    } catch (IOException | UncheckedIOException e) {
      report.say("The folder " + folder + " is left: " + e);
    }
  }
}
