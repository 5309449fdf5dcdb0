package org.dfra.experiments.recruit.simulation;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import org.dfra.recruit.transport.DelayModel;

/** Resamples measured delays: the empirical distribution, interpolated between neighbours. */
public final class MeasuredDelays implements DelayModel {

  /** The column of the file. */
  static final String COLUMN = "delay_ms";

  /**
   * Measured once, and not replaced, so that the figures of experiments stay comparable. A newer
   * measurement gets a version of its own.
   */
  private static final String MESSAGES = "message-delays-v1.csv";

  private final double[] sorted;

  /**
   * @param delays seconds, finite and not negative; at least one
   */
  public MeasuredDelays(double[] delays) {
    this.sorted = delays.clone();
    Arrays.sort(sorted);
    if (sorted.length == 0 || !(sorted[0] >= 0) || !Double.isFinite(sorted[sorted.length - 1])) {
      throw new IllegalArgumentException(
          "the list of measured delays is empty, or has one that is negative or not finite; give"
              + " finite delays of 0 or more");
    }
  }

  /**
   * Reads a file with a column {@value #COLUMN}, milliseconds.
   *
   * @throws IOException if it cannot be read, or has no such column; the message gives the place
   */
  public static MeasuredDelays read(Path csv) throws IOException {
    return of(csv.toString(), Files.readAllLines(csv));
  }

  /**
   * Delays of 2000 messages, from the sending thread of one process to the receiving thread of
   * another, as {@code ./dfra bench recruit --report} measured them once. The same in each build.
   */
  public static MeasuredDelays ofMessages() {
    try (InputStream in = MeasuredDelays.class.getResourceAsStream(MESSAGES)) {
      if (in == null) {
        throw new IllegalStateException(MESSAGES + " is not in this jar; rebuild DFRA");
      }
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return of(MESSAGES, text.lines().toList());
    } catch (IOException e) {
      throw new UncheckedIOException(MESSAGES + " in this jar cannot be read", e);
    }
  }

  private static MeasuredDelays of(String csv, List<String> lines) throws IOException {
    int column =
        lines.isEmpty() ? -1 : Arrays.asList(lines.get(0).strip().split(",")).indexOf(COLUMN);
    if (column < 0) {
      throw new IOException(csv + ": the first line has no column " + COLUMN);
    }
    double[] delays = new double[lines.size() - 1];
    for (int i = 0; i < delays.length; i++) {
      String[] fields = lines.get(i + 1).split(",");
      try {
        delays[i] = Double.parseDouble(fields[column]) / 1000;
      } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
        throw new IOException(
            csv
                + ":"
                + (i + 2)
                + ": \""
                + lines.get(i + 1)
                + "\" has no number in column "
                + COLUMN
                + "; write milliseconds, such as 1.5",
            e);
      }
    }
    try {
      return new MeasuredDelays(delays);
    } catch (IllegalArgumentException e) {
      throw new IOException(csv + ": " + e.getMessage(), e);
    }
  }

  /** The quantile at a fraction, seconds. */
  public double quantile(double share) {
    double place = share * (sorted.length - 1);
    int below = (int) place;
    int above = Math.min(below + 1, sorted.length - 1);
    return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
  }

  @Override
  public double next(RandomGenerator random) {
    return quantile(random.nextDouble());
  }
}
