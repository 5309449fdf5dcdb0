package org.dfra.examples.devices;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * The readings of one module during the demonstration: columns of numbers over time, and the last
 * reading. It is an ordinary listener: the subscription itself recovers after a failure.
 *
 * @param <R> type of the readings
 */
final class ReadingRecorder<R extends Reading> implements ModuleListener, AutoCloseable {

  private static final int DEPTH = 200;

  /** The plotted line is interrupted where the interval exceeds the usual one by this factor. */
  private static final double GAP = 5;

  /** Extracts numbers from a reading. */
  @FunctionalInterface
  interface ColumnExtractor<R> {

    /**
     * @param epoch the module's epoch that the reading is from
     * @return a number for each column
     */
    double[] of(R reading, long epoch);
  }

  private record Row(double seconds, double[] numbers) {}

  private final String path;
  private final Class<R> type;
  private final List<String> columns;
  private final ColumnExtractor<R> numbers;
  private final Instant begin;

  @GuardedBy("this")
  private final List<Row> rows = new ArrayList<>();

  @GuardedBy("this")
  private @Nullable R last;

  @GuardedBy("this")
  private long count;

  private @Nullable Subscription subscription;

  /**
   * @param path the module's path, {@code robot/name}
   * @param columns names of the columns, with units: {@code speed_mps}
   * @param numbers extracts a reading's numbers, one for each column
   * @param begin when the demonstration started; times are seconds since then
   */
  ReadingRecorder(
      String path, Class<R> type, List<String> columns, ColumnExtractor<R> numbers, Instant begin) {
    this.path = path;
    this.type = type;
    this.columns = columns;
    this.numbers = numbers;
    this.begin = begin;
  }

  /** Subscribes. */
  ReadingRecorder<R> subscribeTo(Module module) throws RemoteException {
    subscription =
        module.subscribe(this, DeliveryPolicy.keepLast(DEPTH).withKinds(EventKind.READING));
    return this;
  }

  @Override
  public synchronized void notify(Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading reported
        && type.isInstance(reported.reading())) {
      R reading = type.cast(reported.reading());
      rows.add(new Row(seconds(reading.measured()), numbers.of(reading, delivery.epoch())));
      last = reading;
      count++;
      notifyAll();
    }
  }

  private double seconds(Instant time) {
    return Duration.between(begin, time).toNanos() / 1e9;
  }

  /** {@code robot/name}. */
  String path() {
    return path;
  }

  /** Simple name of the readings' type. */
  String type() {
    return type.getSimpleName();
  }

  /** Number of readings received. */
  synchronized long count() {
    return count;
  }

  /** Number of readings lost. */
  long lost() {
    return subscription == null ? 0 : subscription.lost();
  }

  /** The last reading; null while there is none. */
  synchronized @Nullable R last() {
    return last;
  }

  /**
   * Waits for the reading after the given number; null on a timeout.
   *
   * @param before number of readings that the caller knows
   */
  synchronized @Nullable R next(long before, Duration patience) throws InterruptedException {
    long end = System.nanoTime() + patience.toNanos();
    while (count <= before) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        return null;
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
    return last;
  }

  /** Readings per second, from the first to the last; 0 for fewer than two. */
  synchronized double rate() {
    if (rows.size() < 2) {
      return 0;
    }
    double span = rows.get(rows.size() - 1).seconds() - rows.get(0).seconds();
    return span > 0 ? (rows.size() - 1) / span : 0;
  }

  /** Longest time between two readings, seconds. */
  synchronized double longestGap() {
    double longest = 0;
    for (int i = 1; i < rows.size(); i++) {
      longest = Math.max(longest, rows.get(i).seconds() - rows.get(i - 1).seconds());
    }
    return longest;
  }

  /** A column over time as {@code {times, values}}; NaN in the middle of each gap. */
  synchronized double[][] series(String column) {
    int index = columns.indexOf(column);
    if (index < 0) {
      throw new IllegalArgumentException(path + " has no column " + column + "; it has " + columns);
    }
    double usual = rate() > 0 ? GAP / rate() : Double.POSITIVE_INFINITY;
    List<double[]> points = new ArrayList<>();
    double before = Double.NaN;
    for (Row row : rows) {
      if (row.seconds() - before > usual) {
        points.add(new double[] {(row.seconds() + before) / 2, Double.NaN});
      }
      points.add(new double[] {row.seconds(), row.numbers()[index]});
      before = row.seconds();
    }
    return new double[][] {
      points.stream().mapToDouble(point -> point[0]).toArray(),
      points.stream().mapToDouble(point -> point[1]).toArray()
    };
  }

  /** Writes every reading as a line of CSV. */
  synchronized void write(Path file) throws IOException {
    try (BufferedWriter out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
      out.write("t_s," + String.join(",", columns));
      out.newLine();
      for (Row row : rows) {
        out.write(String.format(Locale.ROOT, "%.4f", row.seconds()));
        for (double number : row.numbers()) {
          out.write(String.format(Locale.ROOT, ",%.7g", number));
        }
        out.newLine();
      }
    }
  }

  @Override
  public void close() {
    if (subscription != null) {
      subscription.close();
    }
  }
}
