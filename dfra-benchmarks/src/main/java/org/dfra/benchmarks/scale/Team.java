package org.dfra.benchmarks.scale;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.dfra.benchmarks.attack.ProcessSample;
import org.dfra.benchmarks.scale.TeamResult.Load;
import org.dfra.benchmarks.scale.TeamResult.Mutual;
import org.dfra.benchmarks.scale.TeamResult.Observed;

/**
 * A team of robots on this computer, each with a lookup service and modules of its own. Used by one
 * thread.
 */
public final class Team implements AutoCloseable {

  /** Number of modules of each robot. */
  public static final int MODULES = 15;

  /** A team of at most so many robots has a process for each. */
  public static final int MAX_PROCESSES = 30;

  /** Number of robots in a process of a larger team, whose JVMs this computer could not run. */
  public static final int PACKED = 5;

  /** Processes that start at the same time: a few for each core. */
  private static final int STARTING = 6;

  private static final int CHANGES = 11;

  /** How long the traffic is measured: a few times the interval of renewals, 10 s. */
  private static final Duration MEASURED = Duration.ofSeconds(30);

  /** Registrations, first reads and their threads are over by then. */
  private static final Duration SETTLING = Duration.ofSeconds(20);

  private final int size;
  private final List<TeamProcess> robots = new ArrayList<>();
  private final List<String> locators = new ArrayList<>();
  private final Consumer<String> progress;

  private Team(int size, Consumer<String> progress) {
    this.size = size;
    this.progress = progress;
  }

  /**
   * Starts a team, and waits until each robot's lookup service lists its modules.
   *
   * @param robots number of robots
   * @param progress receives sentences
   * @throws IOException if a process does not start; its message contains the log
   */
  public static Team start(int robots, Consumer<String> progress)
      throws IOException, InterruptedException {
    int packed = robots > MAX_PROCESSES ? PACKED : 1;
    Team team = new Team(robots, progress);
    try {
      progress.accept(
          "Starting "
              + robots
              + " robots with "
              + MODULES
              + " modules each"
              + (packed > 1 ? ", " + packed + " in a process …" : " …"));
      List<String> names = IntStream.range(0, robots).mapToObj(i -> "robot" + i).toList();
      int awaited = 0;
      for (int i = 0; i < robots; i += packed) {
        List<String> some = names.subList(i, Math.min(robots, i + packed));
        team.robots.add(TeamProcess.robots(some, MODULES, List.of()));
        if (team.robots.size() - awaited >= STARTING) {
          team.locators.addAll(team.robots.get(awaited++).awaitLocators());
        }
      }
      while (awaited < team.robots.size()) {
        team.locators.addAll(team.robots.get(awaited++).awaitLocators());
      }
      return team;
    } catch (IOException | InterruptedException | RuntimeException e) {
      team.close();
      throw e;
    }
  }

  private int modules() {
    return size * MODULES;
  }

  /** Measures with one observer. */
  public Observed measureObserved() throws IOException, InterruptedException {
    try (TeamProcess observer = TeamProcess.observer()) {
      observer.watch(modules(), locators);
      double complete = observer.awaitComplete();
      progress.accept("One observer knows all " + modules() + " modules; measuring its traffic …");
      List<TeamProcess> all = new ArrayList<>(robots);
      all.add(observer);
      List<ProcessTraffic> traffic = measureTraffic(all);
      List<Double> changes = new ArrayList<>();
      for (int i = 0; i < CHANGES; i++) {
        TeamProcess one = robots.get(i * robots.size() / CHANGES);
        long before = one.toggle();
        changes.add((observer.awaitChange() - before) / 1e9);
      }
      return new Observed(
          complete,
          Load.of(traffic.get(robots.size()), 1),
          Load.of(ProcessTraffic.sum(traffic.subList(0, robots.size())), 1),
          changes);
    }
  }

  /**
   * Measures with each robot observing all. They begin to, one process after the other. Afterwards
   * they still do.
   */
  public Mutual measureMutual() throws IOException, InterruptedException {
    double complete = 0;
    for (TeamProcess each : robots) { // together, this computer's cores would not suffice
      each.watch(modules(), locators);
      complete = Math.max(complete, each.awaitComplete());
    }
    progress.accept("Each robot knows all; measuring their traffic …");
    List<Long> pids = robots.stream().map(TeamProcess::pid).toList();
    settle();
    Duration cpu = ProcessSample.cpu(pids);
    long began = System.nanoTime();
    List<ProcessTraffic> traffic = measureTraffic(robots);
    double seconds = (System.nanoTime() - began) / 1e9;
    return new Mutual(
        complete,
        Load.of(ProcessTraffic.sum(traffic), size),
        ProcessSample.cpu(pids).minus(cpu).toNanos() / 1e9 / seconds);
  }

  /** Each process's traffic in a second, over a while. */
  private static List<ProcessTraffic> measureTraffic(List<TeamProcess> of)
      throws IOException, InterruptedException {
    settle();
    List<ProcessTraffic> before = new ArrayList<>();
    List<Long> began = new ArrayList<>();
    for (TeamProcess each : of) {
      before.add(each.traffic());
      began.add(System.nanoTime());
    }
    pass(MEASURED);
    List<ProcessTraffic> traffic = new ArrayList<>();
    for (int i = 0; i < of.size(); i++) {
      ProcessTraffic after = of.get(i).traffic();
      double seconds = (System.nanoTime() - began.get(i)) / 1e9;
      traffic.add(after.perSecond(before.get(i), seconds));
    }
    return traffic;
  }

  private static void settle() throws InterruptedException {
    pass(SETTLING);
  }

  /** There is no condition to wait for: the benchmark measures over this interval. */
  private static void pass(Duration interval) throws InterruptedException {
    boolean unused = new CountDownLatch(1).await(interval.toMillis(), TimeUnit.MILLISECONDS);
  }

  /**
   * Counts the threads of a virtual machine whose modules join several lookup services.
   *
   * @param modules number of its modules
   * @param registrars number of lookup services, its own one among them
   * @return the number of its threads, also those of the virtual machine itself, when all modules
   *     are registered everywhere and it has settled
   */
  public static int threadsOf(int modules, int registrars)
      throws IOException, InterruptedException {
    List<TeamProcess> others = new ArrayList<>();
    try {
      List<String> locators = new ArrayList<>();
      for (int i = 1; i < registrars; i++) {
        TeamProcess other = TeamProcess.robots(List.of("other" + i), 0, List.of());
        others.add(other);
        locators.addAll(other.awaitLocators());
      }
      TeamProcess one = TeamProcess.robots(List.of("robot"), modules, locators);
      others.add(one);
      locators.addAll(one.awaitLocators());
      try (TeamProcess observer = TeamProcess.observer()) {
        observer.watch(modules, locators);
        double unused = observer.awaitComplete();
      }
      settle();
      settle();
      return ProcessSample.threads(one.pid());
    } finally {
      for (TeamProcess each : others) {
        each.close();
      }
    }
  }

  /** Kills all processes. */
  @Override
  public void close() throws InterruptedException {
    for (TeamProcess each : robots) {
      each.close();
    }
  }
}
