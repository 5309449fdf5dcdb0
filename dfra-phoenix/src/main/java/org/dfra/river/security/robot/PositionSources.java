package org.dfra.river.security.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.rmi.RemoteException;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The modules of this process that know the robot's position. While a rule of the policy needs it,
 * this listens to them, which counts as a client: they work. An estimate counts more than a
 * receiver's fix, unless it is not certain enough.
 */
final class PositionSources {

  private static final Logger LOG = LoggerFactory.getLogger(PositionSources.class);

  /** An estimate whose standard deviation is larger does not count, in metres. */
  static final double MAX_SIGMA = 10;

  private static final int ESTIMATE = 2;
  private static final int FIX = 1;

  /** Enough for a position that counts for two seconds, and little work. */
  private static final double RATE = 5;

  private final RobotFacts facts;

  @GuardedBy("this")
  private final Map<Module, Optional<Subscription>> sources = new HashMap<>();

  PositionSources(RobotFacts facts) {
    this.facts = facts;
  }

  /** Adds a module, if it is one that knows the robot's position. */
  synchronized void add(Module module) {
    if (module instanceof PositionEstimator || module instanceof GPSSensor) {
      sources.put(module, Optional.empty());
    }
  }

  /** Removes a module that ends. */
  synchronized void remove(Module module) {
    @Nullable Optional<Subscription> subscription = sources.remove(module);
    if (subscription != null) {
      subscription.ifPresent(each -> close(module, each));
    }
  }

  /** Begins or ends to listen. */
  synchronized void look(boolean isNeeded) {
    for (Map.Entry<Module, Optional<Subscription>> each : sources.entrySet()) {
      Module module = each.getKey();
      if (isNeeded && each.getValue().isEmpty()) {
        try {
          each.setValue(
              Optional.of(
                  module.subscribe(
                      this::received, DeliveryPolicy.latestReading().withMaxRate(RATE))));
        } catch (RemoteException | RuntimeException e) { // it is tried again
          LOG.warn("The robot's position is not taken from {}: {}", module, e.toString());
        }
      } else if (!isNeeded && each.getValue().isPresent()) {
        each.getValue().ifPresent(subscription -> close(module, subscription));
        each.setValue(Optional.empty());
      }
    }
  }

  private static void close(Module module, Subscription subscription) {
    try {
      subscription.close();
    } catch (RuntimeException e) {
      LOG.warn("{} may still send its position: {}", module, e.toString());
    }
  }

  private void received(Delivery delivery) {
    @Nullable SharedPosition shared = facts.shared();
    if (shared == null || !(delivery.event() instanceof NewReading measured)) {
      return;
    }
    Reading reading = measured.reading();
    @Nullable GeoPosition position = position(reading);
    if (position != null) {
      try {
        shared.write(reading instanceof PoseEstimate ? ESTIMATE : FIX, position);
      } catch (IOException e) {
        LOG.warn("The robot's position is not shared with its processes: {}", e.getMessage());
      }
    }
  }

  /** The position in a reading; null if it has none that counts. */
  static @Nullable GeoPosition position(Reading reading) {
    if (reading instanceof GpsFix fix) {
      return fix.position();
    }
    return reading instanceof PoseEstimate pose
            && pose.fixAge() != null
            && pose.positionSigma() <= MAX_SIGMA
        ? Objects.requireNonNull(pose.position())
        : null;
  }
}
