package org.dfra.examples.mission.monitor;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.dfra.behavior.BehaviorStatus;
import org.dfra.behavior.RasterSearch;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent;
import org.dfra.event.ModuleListener;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.examples.mission.RobotLog;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.DriveState;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;

/**
 * Subscriptions to the readings of one robot's modules. Readings arrive delayed and out of order,
 * each module's on its own thread; they are passed to the robot's log in the order of their
 * measurement, up to a time that the owner sets. Thread-safe.
 */
public final class RobotSubscriptions implements AutoCloseable {

  /** Queue length of each subscription, while this process is slow. */
  private static final int DEPTH = 256;

  private record PendingReading(ModuleListener log, Delivery delivery, Reading reading) {}

  /**
   * A received position.
   *
   * @param receiver the module's name
   * @param measured when, by the robot's time
   * @param epoch the receiver's epoch
   */
  public record ReceivedPosition(String receiver, Instant measured, long epoch) {}

  private final String robot;
  private final RobotLog log;
  private final Map<String, Subscription> subscriptions = new HashMap<>(); // by module

  @GuardedBy("this")
  private final PriorityQueue<PendingReading> waiting =
      new PriorityQueue<>(
          Comparator.comparing((PendingReading received) -> received.reading().measured()));

  @GuardedBy("this")
  private final List<DriveState> wheels = new ArrayList<>();

  @GuardedBy("this")
  private final List<ReceivedPosition> positions = new ArrayList<>();

  @GuardedBy("this")
  private BehaviorStatus newest;

  @GuardedBy("this")
  private BehaviorStatus status;

  /**
   * @param first status of the search before the first received one
   */
  RobotSubscriptions(String robot, RobotLog log, BehaviorStatus first) {
    this.robot = robot;
    this.log = log;
    this.newest = first;
    this.status = first;
  }

  /** Subscribes to all relevant modules of the robot. */
  void subscribe(ModuleDirectory directory) throws RemoteException {
    for (Class<? extends Module> kind : RobotLog.RECORDED_KINDS) {
      listen(directory, kind);
    }
    listen(directory, RasterSearch.class);
    listen(directory, DriveEffector.class);
  }

  private <M extends Module> void listen(ModuleDirectory directory, Class<M> kind)
      throws RemoteException {
    for (ModuleListing<M> each : directory.find(log.query(kind))) {
      ModuleListener taker = log.listener(each.name());
      subscriptions.put(
          each.name(),
          each.module()
              .subscribe(
                  delivery -> take(each.name(), taker, delivery),
                  DeliveryPolicy.keepLast(DEPTH).withKinds(EventKind.READING)));
    }
  }

  private synchronized void take(String module, ModuleListener taker, Delivery delivery) {
    if (!(delivery.event() instanceof ModuleEvent.NewReading fresh)) {
      return;
    }
    Reading reading = fresh.reading();
    waiting.add(new PendingReading(taker, delivery, reading));
    if (reading instanceof BehaviorStatus reported) {
      newest = reported;
    } else if (reading instanceof DriveState reported) {
      wheels.add(reported);
    } else if (reading instanceof GpsFix fix && fix.position() != null) {
      positions.add(new ReceivedPosition(module, fix.measured(), delivery.epoch()));
    }
  }

  /** Passes on the readings that were measured up to a time. */
  synchronized void deliverUntil(Instant until) throws RemoteException {
    for (PendingReading next = waiting.peek();
        next != null && !next.reading().measured().isAfter(until);
        next = waiting.peek()) {
      waiting.remove();
      if (next.reading() instanceof BehaviorStatus reported) {
        status = reported;
      } else {
        next.log().notify(next.delivery());
      }
    }
  }

  /** Status of the search at the time of the last reading passed on. */
  synchronized BehaviorStatus status() {
    return status;
  }

  /** The last received status of the search. */
  public synchronized BehaviorStatus latestStatus() {
    return newest;
  }

  /** When the wheels last received a command to move before a time; null if there was none. */
  public synchronized @Nullable Instant lastCommand(Instant before) {
    return wheels.stream()
        .filter(state -> !state.velocity().isZero() && !state.measured().isAfter(before))
        .map(DriveState::measured)
        .max(Comparator.naturalOrder())
        .orElse(null);
  }

  /** Positions of the receivers, in the order received. */
  public synchronized List<ReceivedPosition> positions() {
    return List.copyOf(positions);
  }

  /** Number of a module's events that were published and not received. */
  public long lost(String module) {
    return subscription(module).lost();
  }

  /** Whether the subscription to a module is known to be interrupted. */
  public boolean isInterrupted(String module) {
    return subscription(module).interruptedSince().isPresent();
  }

  private Subscription subscription(String module) {
    @Nullable Subscription subscription = subscriptions.get(module);
    if (subscription == null) {
      throw new IllegalArgumentException(
          robot + " has no module " + module + " that has a subscription");
    }
    return subscription;
  }

  @Override
  public void close() {
    subscriptions.values().forEach(Subscription::close);
  }
}
