package org.dfra.app.doctor;

import java.util.ArrayList;
import java.util.List;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.persona.EmergencyStopAttributes;

/** Which effectors are stopped for an emergency, and so obey nobody. */
final class StopCheck implements Check {

  /**
   * An effector that is stopped.
   *
   * @param robot name of its robot
   * @param module its path, {@code robot/name}
   * @param stop since when and by whom
   */
  record StoppedEffector(String robot, String module, EmergencyStopAttributes stop) {}

  /** Looks for those that are. */
  interface StopProbe {
    List<StoppedEffector> stopped() throws InterruptedException;
  }

  private final StopProbe stops;

  StopCheck(StopProbe stops) {
    this.stops = stops;
  }

  @Override
  public Subject subject() {
    return Subject.EMERGENCY_STOP;
  }

  @Override
  public List<Finding> run() throws InterruptedException {
    List<Finding> findings = new ArrayList<>();
    for (StoppedEffector each : stops.stopped()) {
      EmergencyStopAttributes stop = each.stop();
      EmergencyStopState state =
          new EmergencyStopState(true, stop.requester(), stop.since(), true, null);
      findings.add(
          Finding.warn(
              subject(),
              each.module() + " is stopped " + state.inWords() + ", and obeys nobody",
              "When it is safe, release it: ./dfra stop --release " + each.robot() + "."));
    }
    return findings;
  }
}
