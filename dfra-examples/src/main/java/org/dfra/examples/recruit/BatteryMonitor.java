package org.dfra.examples.recruit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.rmi.RemoteException;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.directory.DirectoryListener;
import org.dfra.directory.DirectoryRegistration;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.BatterySensor;
import org.dfra.flow.sensor.BatteryState;
import org.jspecify.annotations.Nullable;

/** The battery charge of a team's robots, as their batteries publish it. Thread-safe. */
final class BatteryMonitor implements AutoCloseable, DirectoryListener<BatterySensor> {

  private static final double HERTZ = 1;

  private volatile @Nullable DirectoryRegistration watch; // set when it starts

  @GuardedBy("this")
  private final Map<String, Subscription> subscriptions = new TreeMap<>();

  // by robot
  @GuardedBy("this")
  private final Map<String, Double> charges = new TreeMap<>();

  @GuardedBy("this")
  private boolean isOver;

  private BatteryMonitor() {}

  /** Subscribes to batteries as they appear. */
  static BatteryMonitor start(ModuleDirectory directory) {
    BatteryMonitor monitor = new BatteryMonitor();
    monitor.watch = directory.listen(ModuleQuery.of(BatterySensor.class), monitor);
    return monitor;
  }

  @Override
  public synchronized void matched(ModuleListing<BatterySensor> listing) {
    String robot = listing.robot();
    if (isOver || subscriptions.containsKey(robot)) {
      return; // its subscription registers itself again
    }
    try {
      subscriptions.put(
          robot,
          listing
              .module()
              .subscribe(
                  delivery -> received(robot, delivery),
                  DeliveryPolicy.latestReading().withMaxRate(HERTZ)));
    } catch (RemoteException e) {
      charges.remove(robot); // not known, as the table shows
    }
  }

  private synchronized void received(String robot, Delivery delivery) {
    if (delivery.event() instanceof ModuleEvent.NewReading fresh
        && fresh.reading() instanceof BatteryState state) {
      @Nullable Double left = state.remaining();
      if (left == null) {
        charges.remove(robot);
      } else {
        charges.put(robot, left);
      }
    }
  }

  /** Charge left, 0 to 1; null if not known. */
  synchronized @Nullable Double charge(String robot) {
    return charges.get(robot);
  }

  @Override
  public void close() {
    DirectoryRegistration watching = watch;
    if (watching != null) {
      watching.close();
    }
    List<Subscription> ending;
    synchronized (this) {
      isOver = true;
      ending = List.copyOf(subscriptions.values());
    }
    ending.forEach(Subscription::close);
  }
}
