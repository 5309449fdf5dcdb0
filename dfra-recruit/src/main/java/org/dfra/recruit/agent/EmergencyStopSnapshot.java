package org.dfra.recruit.agent;

import java.rmi.RemoteException;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.core.module.ModuleContext;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/**
 * The last emergency stop of each of a robot's drives at one time. Snapshots are compared by
 * equality of the stops, never by time order: the clock may be set between them.
 *
 * @param last time of each last stop or release, as text, by the path of the module
 */
record EmergencyStopSnapshot(Map<String, String> last) {

  private static final String NEVER = "never";

  EmergencyStopSnapshot {
    last = Map.copyOf(last);
  }

  /**
   * Queries all drives found.
   *
   * @return empty where some are stopped now
   * @throws RemoteException if one does not respond
   */
  static Optional<EmergencyStopSnapshot> query(ModuleContext context) throws RemoteException {
    Map<String, String> found = new TreeMap<>();
    boolean isStopped = false;
    for (ModuleListing<DriveEffector> each :
        context.directory().find(ModuleQuery.of(DriveEffector.class).robot(context.robot()))) {
      EmergencyStopState stop = each.module().emergencyStopState();
      isStopped |= stop.latched();
      found.put(each.path(), Objects.toString(stop.since(), NEVER));
    }
    return isStopped ? Optional.empty() : Optional.of(new EmergencyStopSnapshot(found));
  }

  /**
   * Whether one of the drives was stopped, or released, between this snapshot and a later one.
   *
   * @param known gives the last known stop of drives that were not found then; null where unknown,
   *     so that no comparison is possible
   */
  boolean differsFrom(EmergencyStopSnapshot later, Function<String, @Nullable String> known) {
    return later.last().entrySet().stream()
        .anyMatch(
            now -> {
              @Nullable String before = last.get(now.getKey());
              @Nullable String compared = before == null ? known.apply(now.getKey()) : before;
              return compared != null
                  && !now.getValue().equals(NEVER) // it was stopped, or lost the record of its stop
                  && !now.getValue().equals(compared);
            });
  }

  /** The text for {@link #parse}. */
  String text() {
    return last.entrySet().stream()
        .map(each -> each.getKey() + " " + each.getValue())
        .sorted()
        .collect(Collectors.joining("\n"));
  }

  static EmergencyStopSnapshot parse(String text) {
    return new EmergencyStopSnapshot(
        text.lines()
            .map(line -> line.split(" ", 2))
            .filter(line -> line.length == 2)
            .collect(Collectors.toMap(line -> line[0], line -> line[1], (one, other) -> other)));
  }
}
