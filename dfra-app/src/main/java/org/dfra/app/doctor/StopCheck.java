package org.dfra.app.doctor;

import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.effector.StopState;
import org.dfra.persona.StopAttributes;

/** Which effectors are stopped for an emergency, and so obey nobody. */
final class StopCheck implements Check {

  /**
   * An effector that is stopped.
   *
   * @param robot name of its robot
   * @param module its path, {@code robot/name}
   * @param stop since when and by whom
   */
  record Stopped(String robot, String module, StopAttributes stop) {}

  /** Looks for those that are. */
  interface Stops {
    List<Stopped> stopped() throws InterruptedException;
  }

  private final Stops stops;

  StopCheck(Stops stops) {
    this.stops = stops;
  }

  @Override
  public Subject subject() {
    return Subject.EMERGENCY_STOP;
  }

  @Override
  public List<Finding> examine() throws InterruptedException {
    List<Finding> findings = new ArrayList<>();
    for (Stopped each : stops.stopped()) {
      StopAttributes stop = each.stop();
      StopState state = new StopState(true, stop.by(), stop.since(), true, null);
      findings.add(
          Finding.warn(
              subject(),
              each.module() + " is stopped " + state.inWords() + ", and obeys nobody",
              "When it is safe, release it: ./dfra stop --release " + each.robot() + "."));
    }
    return findings;
  }
}
