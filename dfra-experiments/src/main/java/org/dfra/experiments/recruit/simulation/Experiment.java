package org.dfra.experiments.recruit.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.CellResult;
import org.dfra.experiments.recruit.simulation.ExperimentGrid.ExperimentCell;

/**
 * Runs cells over seeds. With the simulated network the results depend only on these and the plan.
 */
public final class Experiment {

  /** Receives the progress, from several threads. */
  @FunctionalInterface
  public interface Progress {
    void done(int runs, int ofThem);
  }

  private final ExperimentPlan plan;
  private final int threads;
  private final ExperimentEnvironment.Factory venues;

  /**
   * With the simulated network.
   *
   * @param threads number of parallel runs; at least 1. They end with {@link #run}.
   */
  public Experiment(ExperimentPlan plan, int threads) {
    this(plan, threads, VirtualTimeEnvironment::new);
  }

  /**
   * The same in another environment.
   *
   * @param venues creates the environments of runs; several at once
   */
  public Experiment(ExperimentPlan plan, int threads, ExperimentEnvironment.Factory venues) {
    this.plan = plan;
    this.threads = threads;
    this.venues = venues;
  }

  /**
   * Runs every cell with every seed.
   *
   * @return a result for each cell, in their order
   * @throws InterruptedException if the calling thread was interrupted; the runs are then
   *     interrupted, too
   */
  public List<CellResult> run(List<ExperimentCell> cells, long[] seeds, Progress progress)
      throws InterruptedException {
    int all = cells.size() * seeds.length;
    AtomicInteger done = new AtomicInteger();
    ExecutorService pool =
        Executors.newFixedThreadPool(
            threads,
            task -> {
              Thread thread = new Thread(task, "dfra-recruit-runs");
              thread.setDaemon(true);
              return thread;
            });
    try {
      List<List<Future<RunResult>>> under = new ArrayList<>();
      for (ExperimentCell cell : cells) {
        under.add(
            LongStream.of(seeds)
                .mapToObj(
                    seed ->
                        pool.submit(
                            () -> {
                              RunResult result = run(cell, seed);
                              progress.done(done.incrementAndGet(), all);
                              return result;
                            }))
                .toList());
      }
      return results(cells, under);
    } finally {
      List<Runnable> unused = pool.shutdownNow();
    }
  }

  private RunResult run(ExperimentCell cell, long seed) throws Exception {
    try (ExperimentEnvironment environment = venues.create(cell, plan, seed)) {
      return new FieldRun(cell, plan, seed, environment).run();
    }
  }

  private static List<CellResult> results(
      List<ExperimentCell> cells, List<List<Future<RunResult>>> under) throws InterruptedException {
    List<CellResult> results = new ArrayList<>();
    for (int i = 0; i < cells.size(); i++) {
      List<RunResult> runs = new ArrayList<>();
      for (Future<RunResult> each : under.get(i)) {
        try {
          runs.add(each.get());
        } catch (ExecutionException e) {
          throw new IllegalStateException("a run of " + cells.get(i) + " failed", e.getCause());
        }
      }
      results.add(new CellResult(cells.get(i), runs));
    }
    return results;
  }

  /**
   * The result of one run.
   *
   * @param seed of the run
   * @param calls number of calls for help
   * @param completed number of those with a complete recruitment
   * @param successes number of those in which the helper arrived within the deadline
   * @param transmissions number of transmissions, a broadcast counted once
   * @param receptions the same, a broadcast counted once per receiver
   * @param allocation mean time from a call to the first choice, seconds; NaN where no robot was
   *     chosen
   * @param arrival mean time from a call to the helper's arrival, seconds; NaN where none arrived
   * @param regret mean excess travel time of the chosen robot over the nearest free one, seconds;
   *     NaN where none was chosen
   * @param duplicateHelpers number of times that a second robot was on its way to a call or there
   * @param orphanedHelpers number of times that a robot was on its way or there for longer than 2 s
   *     although its requester did not expect it; includes robots that were not free at the end
   * @param rasterTimeLost time of scanners away from their routes, seconds
   * @param travel mean distance of each ground vehicle for others and back, metres
   */
  public record RunResult(
      long seed,
      int calls,
      int completed,
      int successes,
      long transmissions,
      long receptions,
      double allocation,
      double arrival,
      double regret,
      int duplicateHelpers,
      int orphanedHelpers,
      double rasterTimeLost,
      double travel) {

    /** Transmissions per completed recruitment; NaN where none was. */
    public double transmissionsEach() {
      return completed == 0 ? Double.NaN : (double) transmissions / completed;
    }

    /** The same with a broadcast counted once per receiver. */
    public double receptionsEach() {
      return completed == 0 ? Double.NaN : (double) receptions / completed;
    }
  }
}
