package org.dfra.experiments.recruit.embedded;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.core.robot.ResourceCloser;
import org.dfra.experiments.recruit.simulation.Experiment;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;
import org.dfra.experiments.recruit.simulation.ExperimentPlan;
import org.dfra.experiments.recruit.simulation.Seeds;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A part of the experiment's cells over real JERI and remote events, in this JVM. */
public final class EmbeddedRuns implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(EmbeddedRuns.class);

  private static final int CALLS = 3;
  private static final Duration PERIOD = Duration.ofSeconds(150);
  private static final Duration REST = Duration.ofSeconds(200);

  private final ExperimentPlan plan;
  private final int atOnce;
  private final double speed;
  private final Map<ExperimentCell, MessageDelays> times = new ConcurrentHashMap<>();
  private final Map<Integer, Queue<EmbeddedTeam>> free = new ConcurrentHashMap<>(); // by size

  /**
   * @param plan common settings of all cells
   * @param parallelRuns number of parallel runs
   * @param speed seconds of the agents' time per real second
   */
  public EmbeddedRuns(ExperimentPlan plan, int parallelRuns, double speed) {
    this.plan = plan;
    this.atOnce = parallelRuns;
    this.speed = speed;
  }

  /** The experiment's plan with fewer calls at shorter intervals. */
  public static ExperimentPlan shorter(ExperimentPlan plan) {
    return plan.with(CALLS, PERIOD, REST);
  }

  /** The cells: two strategies, with few and more vehicles, without loss and with high loss. */
  public static List<ExperimentCell> cells() {
    List<ExperimentCell> cells = new ArrayList<>();
    for (String strategy : List.of("affective", "greedy")) {
      for (MessageMode mode : MessageMode.values()) {
        for (int vehicles : List.of(3, 6)) {
          for (double loss : List.of(0.0, 0.25)) {
            cells.add(new ExperimentCell(strategy, mode, vehicles, loss));
          }
        }
      }
    }
    return cells;
  }

  /**
   * Runs every cell with every seed, small teams first. Before the first measured run, it starts as
   * many teams as there are parallel runs; a team ends when no cell is left for it.
   *
   * @return a result for each cell, in their order
   */
  public List<CellResult> run(
      List<ExperimentCell> cells, long[] seeds, Experiment.Progress progress)
      throws InterruptedException {
    Map<ExperimentCell, CellResult> results = new HashMap<>();
    int all = cells.size() * seeds.length;
    for (int vehicles : cells.stream().map(ExperimentCell::vehicles).distinct().sorted().toList()) {
      List<ExperimentCell> some =
          cells.stream().filter(each -> each.vehicles() == vehicles).toList();
      warmUp(some);
      int before = results.size() * seeds.length;
      new Experiment(
              plan, atOnce, (cell, same, seed) -> environment(cell, same, seed, delays(cell)))
          .run(some, seeds, (done, ofThem) -> progress.done(before + done, all))
          .forEach(each -> results.put(each.cell(), each));
      end(vehicles);
    }
    return cells.stream().map(results::get).toList();
  }

  /** Parallel runs that are not measured: teams start, and the JIT compiler warms up. */
  private void warmUp(List<ExperimentCell> cells) throws InterruptedException {
    MessageDelays forgotten = new MessageDelays();
    int each = (atOnce + cells.size() - 1) / cells.size();
    new Experiment(
            plan.with(1, plan.period(), plan.settlingTime()),
            each * cells.size(),
            (cell, same, seed) -> environment(cell, same, seed, forgotten))
        .run(cells, Seeds.tuning(each), (done, all) -> {});
  }

  private EmbeddedEnvironment environment(
      ExperimentCell cell, ExperimentPlan same, long seed, MessageDelays noted) throws IOException {
    return new EmbeddedEnvironment(
        cell, same, seed, team(cell.vehicles()), used -> free(cell.vehicles()).add(used), noted);
  }

  private Queue<EmbeddedTeam> free(int vehicles) {
    return free.computeIfAbsent(vehicles, size -> new ConcurrentLinkedQueue<>());
  }

  /** An idle team, or a new one. */
  private EmbeddedTeam team(int vehicles) throws IOException {
    EmbeddedTeam rested = free(vehicles).poll();
    return rested == null ? new EmbeddedTeam(speed) : rested;
  }

  /**
   * Ends all in parallel: each waits for answers of its lookup service. Failures do not affect the
   * measurements.
   */
  private void end(int vehicles) {
    ResourceCloser ending = new ResourceCloser("the experiment");
    List<Thread> threads = new ArrayList<>();
    for (EmbeddedTeam each = free(vehicles).poll(); each != null; each = free(vehicles).poll()) {
      EmbeddedTeam team = each;
      Thread thread = new Thread(() -> ending.close(team), "dfra-team-end");
      thread.start();
      threads.add(thread);
    }
    try {
      for (Thread thread : threads) {
        thread.join();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // they still end
    }
    try {
      ending.throwIfFailed();
    } catch (IOException e) {
      LOG.warn("{}", e.getMessage(), e);
    }
  }

  /** Ends all agents. */
  @Override
  public void close() {
    for (int each : free.keySet()) {
      end(each);
    }
  }

  /** The message delays in the runs of a cell. */
  public MessageDelays delays(ExperimentCell cell) {
    return times.computeIfAbsent(cell, each -> new MessageDelays());
  }
}
