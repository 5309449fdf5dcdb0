package org.dfra.benchmarks.start;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.dfra.benchmarks.call.JitSetting;
import org.dfra.benchmarks.micro.FuzzyStepBenchmark;
import org.dfra.benchmarks.micro.TemplateMatchBenchmark;
import org.dfra.benchmarks.task.Task;
import org.dfra.benchmarks.task.TaskProcess;

/**
 * What groups of schemas and behaviours compute, in a process of its own: a step of the waypoint
 * controller or the search of a camera's image.
 */
public final class ComputingTask implements Task {

  private static final Duration PATIENCE = Duration.ofMinutes(5);
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double NANOS = 1e9;

  /** For {@link TaskProcess}. */
  public ComputingTask() {}

  /** What is computed. */
  public enum Work {

    /** A step of the waypoint controller, with its 135 rules. */
    FUZZY("waypoint controller", 20_000),

    /** The mine detector's search of an image. */
    IMAGE("search of an image", 400);

    private final String label;
    private final int steps;

    Work(String label, int steps) {
      this.label = label;
      this.steps = steps;
    }

    /** Its name in tables and records. */
    public String label() {
      return label;
    }
  }

  /**
   * The result of one process.
   *
   * @param stepMicros median time of the last quarter of the steps
   * @param firstSeconds CPU time of the process until the first quarter was done, its start and the
   *     compilers included
   * @param megabytes memory at the end (PSS)
   */
  public record Result(double stepMicros, double firstSeconds, double megabytes) {}

  /** Computes in a new process. */
  public static Result measure(Work work, JitSetting jit) throws Exception {
    try (TaskProcess process =
        TaskProcess.start(List.of(), options(jit), ComputingTask.class, work.name())) {
      String[] words = process.awaitLine("done ", PATIENCE).split(" ");
      Result result =
          new Result(
              Double.parseDouble(words[1]),
              Double.parseDouble(words[2]),
              RobotStart.megabytes(process.pid()));
      process.write("end");
      int unused = process.awaitEnd(PATIENCE);
      return result;
    }
  }

  /** The heap is that of groups. */
  private static List<String> options(JitSetting jit) {
    return Stream.concat(Stream.of("-Xms24m", "-Xmn8m"), jit.options().stream()).toList();
  }

  @Override
  public void run(String[] args, PrintStream out) throws IOException {
    Work work = Work.valueOf(args[0]);
    Runnable step = step(work);
    int quarter = work.steps / 4;
    double[] micros = new double[quarter];
    double first = 0;
    for (int i = 0; i < work.steps; i++) {
      long began = System.nanoTime();
      step.run();
      micros[i % quarter] = (System.nanoTime() - began) / NANOS_PER_MICRO;
      if (i == quarter) {
        first = cpuSeconds();
      }
    }
    Arrays.sort(micros);
    out.printf(Locale.ROOT, "done %.3f %.3f%n", micros[quarter / 2], first);
    int unused = System.in.read(); // it is measured meanwhile
  }

  private static Runnable step(Work work) {
    if (work == Work.FUZZY) {
      FuzzyStepBenchmark controller = new FuzzyStepBenchmark();
      controller.start();
      return controller::step;
    }
    TemplateMatchBenchmark detector = new TemplateMatchBenchmark();
    return detector::light;
  }

  private static double cpuSeconds() {
    return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
            .getProcessCpuTime()
        / NANOS;
  }
}
