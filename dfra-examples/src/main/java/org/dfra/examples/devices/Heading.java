package org.dfra.examples.devices;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.AngularRateSensor;
import org.jspecify.annotations.Nullable;

/**
 * The robot's rotation since the start, integrated from the gyro's yaw rate. The gyro's bias is
 * subtracted: the mean rate while the robot is stopped at the start.
 */
final class Heading implements ModuleListener, AutoCloseable {

  private static final int DEPTH = 500;

  private volatile @Nullable Subscription subscription; // set when it starts

  @GuardedBy("this")
  private double heading;

  @GuardedBy("this")
  private double sum;

  @GuardedBy("this")
  private int count;

  @GuardedBy("this")
  private @Nullable Double bias;

  @GuardedBy("this")
  private @Nullable Instant last;

  private Heading() {}

  /** Subscribes to a gyro's rates. */
  static Heading start(AngularRateSensor gyro) throws RemoteException {
    Heading heading = new Heading();
    heading.subscription =
        gyro.subscribe(heading, DeliveryPolicy.keepLast(DEPTH).withKinds(EventKind.READING));
    return heading;
  }

  @Override
  public synchronized void notify(Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading reported
        && reported.reading() instanceof AngularRate rate) {
      if (bias == null) {
        sum += rate.rate();
        count++;
      } else if (last != null) {
        double seconds = Duration.between(last, rate.measured()).toNanos() / 1e9;
        heading += (rate.rate() - bias) * seconds;
      }
      last = rate.measured();
      notifyAll();
    }
  }

  /**
   * Ends the calibration: the robot was stopped until now, so the mean rate is the bias.
   *
   * @return it, radians per second
   * @throws IllegalStateException if the gyro has published nothing
   */
  synchronized double calibrate() {
    if (count == 0) {
      throw new IllegalStateException("the gyro has published no rate yet");
    }
    double mean = sum / count;
    bias = mean;
    return mean;
  }

  /** Number of rates received before the calibration. */
  synchronized int stationarySamples() {
    return count;
  }

  /** Radians since the calibration, positive to the left, not wrapped. */
  synchronized double heading() {
    return heading;
  }

  @Override
  public void close() {
    Subscription subscribed = subscription;
    if (subscribed != null) {
      subscribed.close();
    }
  }
}
