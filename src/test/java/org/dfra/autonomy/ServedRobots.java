package org.dfra.autonomy;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.directory.ModuleListing;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.event.Subscription;
import org.dfra.module.Module;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.server.ModuleServer;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;

/**
 * Modules as the properties that come with DFRA describe them, served from this virtual machine and
 * found in a lookup service; among them a {@link SmallRobot}, named {@code robot}.
 */
final class ServedRobots implements AutoCloseable {

  private final Path folder;
  private final EmbeddedReggie reggie;
  private final Duration patience;
  private final Deque<ModuleServer<?>> served = new ArrayDeque<>();
  private final JiniModuleDirectory directory;

  /**
   * @param folder for what they keep
   * @param patience how long a module may take to be found
   */
  ServedRobots(Path folder, EmbeddedReggie reggie, Duration patience) throws Exception {
    this.folder = folder;
    this.reggie = reggie;
    this.patience = patience;
    this.directory = reggie.directory();
  }

  JiniModuleDirectory directory() {
    return directory;
  }

  /** The robot's body, where it began, and all that drives it to a waypoint. */
  void serveSmallRobot() throws Exception {
    SmallRobot.reset();
    device("odometry", "rflex-odometry", SmallRobot.Counter.class);
    device("gps", "ubx", SmallRobot.Receiver.class);
    device("laser", "lms200", SmallRobot.Laser.class);
    device("drive", "rflex-drive", SmallRobot.Wheels.class);
    serve("range_filter", "range-filter", Map.of());
    serve("position", "position-estimator", Map.of("initial_yaw", "0", "gps_bias_sigma", "0"));
    serve("heading_error", "heading-error", Map.of());
    serve("fuzzy_drive", "fuzzy-drive", Map.of());
    serve("go_to_waypoint", "go-to-waypoint", Map.of());
  }

  void serve(String name, String properties, Map<String, String> parameters) throws Exception {
    serve("robot", name, properties, parameters);
  }

  /** The last that was served ends first. */
  void serve(String robot, String name, String properties, Map<String, String> parameters)
      throws Exception {
    served.push(
        ServedModule.fromProperties(folder, name, properties, parameters)
            .on(robot)
            .joining(reggie)
            .serve());
  }

  /** The same with a driver that needs no device. */
  private void device(String name, String properties, Class<? extends ModuleImpl> driver)
      throws Exception {
    served.push(
        ServedModule.fromProperties(folder, name, properties, Map.of())
            .withDriver(driver)
            .joining(reggie)
            .serve());
  }

  ModuleListing<?> find(String query) throws Exception {
    return directory
        .findFirst(new QueryParser(QueryTypeNames.standard()).parse(query), patience)
        .orElseThrow(() -> new AssertionError("nothing is a " + query));
  }

  /** The readings of that type that a module publishes from now on. */
  static <R extends Reading> List<R> received(Module from, Class<R> type) throws Exception {
    List<R> all = new CopyOnWriteArrayList<>();
    Subscription open =
        from.subscribe(
            delivery -> {
              if (delivery.event() instanceof ModuleEvent.NewReading fresh
                  && type.isInstance(fresh.reading())) {
                all.add(type.cast(fresh.reading()));
              }
            },
            DeliveryPolicy.keepLast(1000));
    assertThat(open.isOpen()).isTrue();
    return all;
  }

  @Override
  public void close() {
    directory.close();
    while (!served.isEmpty()) {
      served.pop().close();
    }
  }
}
