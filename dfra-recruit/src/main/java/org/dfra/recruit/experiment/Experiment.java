package org.dfra.recruit.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;

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
    this(plan, threads, SimulatedEnvironment::new);
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
    try (ExperimentEnvironment venue = venues.create(cell, plan, seed)) {
      return new FieldRun(cell, plan, seed, venue).run();
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
}
