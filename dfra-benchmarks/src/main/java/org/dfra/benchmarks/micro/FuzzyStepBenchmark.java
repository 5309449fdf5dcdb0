package org.dfra.benchmarks.micro;

import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.behaviors.fuzzy.Inference;
import org.dfra.behaviors.motor.FuzzyDriveImpl;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.motor.DriveAdvice;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.HeadingPercept;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * A step of the waypoint controller: the 135 Mamdani rules of {@code config/fuzzy/waypoint.fis}.
 * The inputs are drawn evenly: clearances of 0 m to 8 m, heading errors of −180° to 180°; always
 * the same ones. Microseconds.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class FuzzyStepBenchmark {

  /** The controller's rules. */
  static final Path CONTROLLER =
      Path.of(System.getProperty("dfra.root", ".")).resolve("config/fuzzy/waypoint.fis");

  private static final String FRAME = "bench/base_link";
  private static final double FREE = 8; // metres
  private static final int INPUTS = 1024;
  private static final int SEED = 135;

  private final FuzzyDriveImpl drive =
      new FuzzyDriveImpl(
          new ModuleContext(
              "bench",
              "fuzzy_drive",
              Parameters.of("bench/fuzzy_drive", Map.of("system_file", CONTROLLER.toString())),
              InstantSource.system()));
  private final Inference inference = FuzzySystem.read(CONTROLLER).inference();
  private final Clearance[] clearances = new Clearance[INPUTS];
  private final HeadingPercept[] headings = new HeadingPercept[INPUTS];
  private final double[][] inputs = new double[INPUTS][];
  private final double[] outputs = new double[2];
  private int next;

  /** For JMH. */
  public FuzzyStepBenchmark() {
    Random random = new Random(SEED);
    Arrays.setAll(
        inputs,
        i ->
            new double[] {
              FREE * random.nextDouble(),
              FREE * random.nextDouble(),
              FREE * random.nextDouble(),
              360 * random.nextDouble() - 180
            });
    Arrays.setAll(
        clearances,
        i -> new Clearance(Instant.EPOCH, FRAME, inputs[i][0], inputs[i][1], inputs[i][2]));
    Arrays.setAll(
        headings,
        i ->
            new HeadingPercept(
                Instant.EPOCH, FRAME, Math.toRadians(inputs[i][3]), 0.05, 0.1, 12, 8, 8));
  }

  /** Starts the controller. */
  @Setup
  public void start() {
    drive.start();
  }

  /** Ends it. */
  @TearDown
  public void close() {
    drive.close();
  }

  /**
   * The whole step, as a robot executes it: from two percepts to the advice, with the rule in
   * words, which is published as an event without listeners.
   */
  @Benchmark
  public DriveAdvice step() {
    int input = next();
    return drive.advise(clearances[input], headings[input]);
  }

  /**
   * Only the inference of the step, from numbers to numbers: forward speed and yaw rate, fractions
   * of their maximum. The returned array is used again.
   */
  @Benchmark
  public double[] inference() {
    inference.evaluate(inputs[next()], outputs);
    return outputs;
  }

  private int next() {
    next = (next + 1) % INPUTS;
    return next;
  }
}
