package org.dfra.examples.persona;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.report.progress.DemoAssertions;

/**
 * A client's subscription to one receiver, with the time and the number of each of its readings. It
 * contains no code for failures: the subscription itself recovers.
 */
final class FixLog implements AutoCloseable {

  /** Length of the client's event queue; it never fills. */
  private static final int DEPTH = 20;

  private final ModuleListing<GPSSensor> listing;
  private final Subscription subscription;
  private final Arrivals arrivals = new Arrivals();

  private FixLog(ModuleListing<GPSSensor> listing) throws RemoteException {
    this.listing = listing;
    this.subscription = listing.module().subscribe(arrivals, DeliveryPolicy.keepLast(DEPTH));
  }

  /** Subscribes. */
  static FixLog of(ModuleListing<GPSSensor> listing) throws RemoteException {
    return new FixLog(listing);
  }

  /**
   * A received reading.
   *
   * @param nanos arrival time by {@link System#nanoTime}
   * @param life the receiver's epoch; each start of its server begins one
   * @param number its number among all of the receiver's readings
   */
  record Arrival(long nanos, long life, long number) {}

  private static final class Arrivals implements ModuleListener {
    @GuardedBy("this")
    final List<Arrival> all = new ArrayList<>();

    @Override
    public synchronized void notify(Delivery delivery) {
      if (delivery.kind() == EventKind.READING) {
        all.add(new Arrival(System.nanoTime(), delivery.epoch(), delivery.sequence()));
        notifyAll();
      }
    }
  }

  /** {@code robot/module}. */
  String path() {
    return listing.path();
  }

  /** Name of the module, which is also that of its service group in these robots. */
  String module() {
    return listing.name();
  }

  GPSSensor gps() {
    return listing.module();
  }

  Subscription subscription() {
    return subscription;
  }

  /** The next reading. */
  Arrival next(Duration patience) throws IOException, InterruptedException {
    long now = System.nanoTime();
    return first(each -> each.nanos() - now > 0, patience);
  }

  /** The first reading of a later epoch than this. */
  Arrival firstAfterLife(long life, Duration patience) throws IOException, InterruptedException {
    return first(each -> each.life() > life, patience);
  }

  private Arrival first(Predicate<Arrival> wanted, Duration patience)
      throws IOException, InterruptedException {
    long end = System.nanoTime() + patience.toNanos();
    synchronized (arrivals) {
      while (true) {
        for (Arrival each : arrivals.all) {
          if (wanted.test(each)) {
            return each;
          }
        }
        long left = end - System.nanoTime();
        if (left <= 0) {
          throw new IOException(
              "no reading of " + path() + " came within " + patience.toSeconds() + " s");
        }
        TimeUnit.NANOSECONDS.timedWait(arrivals, left);
      }
    }
  }

  /** Starts a recording period with the next reading. */
  RecordingPeriod begin() {
    return new RecordingPeriod(System.nanoTime(), subscription.lost());
  }

  /** The readings from a moment on. */
  final class RecordingPeriod {
    private final long from;
    private final long lostBefore;

    private RecordingPeriod(long from, long lostBefore) {
      this.from = from;
      this.lostBefore = lostBefore;
    }

    /** Waits for this number of readings. */
    void await(int readings, Duration patience) throws Exception {
      DemoAssertions.await(
          readings + " readings of " + path(), patience, () -> end().readings() >= readings);
    }

    /** Number of readings, longest interval, and number of lost events, until now. */
    Summary end() {
      long now = System.nanoTime();
      long[] times;
      synchronized (arrivals) {
        times =
            arrivals.all.stream().mapToLong(Arrival::nanos).filter(t -> t - from >= 0).toArray();
      }
      long longest = 0;
      long last = from;
      for (long each : times) {
        longest = Math.max(longest, each - last);
        last = each;
      }
      longest = Math.max(longest, now - last);
      double rate = times.length < 2 ? 0 : (times.length - 1) * 1e9 / (last - times[0]);
      long lost = subscription.lost() - lostBefore;
      return new Summary(path(), times.length, rate, Duration.ofNanos(longest), lost);
    }
  }

  /**
   * The summary of a period.
   *
   * @param path of the receiver
   * @param readings number of readings received
   * @param rate of the readings, in hertz; 0 for fewer than two
   * @param longestWait without a reading
   * @param lost events, readings or others, that were missing in the numbers
   */
  record Summary(String path, int readings, double rate, Duration longestWait, long lost) {}

  @Override
  public void close() {
    subscription.close();
  }
}
