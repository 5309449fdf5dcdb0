package org.dfra.cli.doctor;

import java.util.ArrayList;
import java.util.List;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.persona.EmergencyStopAttributes;

/** Checks which effectors are in emergency stop, and so ignore all commands. */
final class StopCheck implements Check {

  /**
   * An effector in emergency stop.
   *
   * @param robot name of its robot
   * @param module its path, {@code robot/name}
   * @param stop its time and requester
   */
  record StoppedEffector(String robot, String module, EmergencyStopAttributes stop) {}

  /** Finds those effectors. */
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
              each.module() + " is stopped " + state.inWords() + ", and executes no commands",
              "When it is safe, release it: "
                  + CommandName.current()
                  + " stop --release "
                  + each.robot()
                  + "."));
    }
    return findings;
  }
}
