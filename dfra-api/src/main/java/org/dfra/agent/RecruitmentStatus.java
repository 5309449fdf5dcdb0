package org.dfra.agent;

import java.time.Instant;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * The state of a recruitment agent, published whenever it changes.
 *
 * @param measured when this was the state, by the robot's clock, UTC
 * @param requesterPhase its phase as a requester
 * @param helperRobot the robot that it has chosen; null if none
 * @param responderPhase its phase as a responder
 * @param helpedRobot the robot that it helps or has offered to help; null if none
 * @param urge its motivation to help, 0 to 1; at 1 it helps
 * @param lastChange the last change, as a clause for operators
 * @param holdReason why its robot answers no calls, as a clause: an operator stopped it and none
 *     has resumed it; null if it is not held
 */
public record RecruitmentStatus(
    Instant measured,
    RequesterPhase requesterPhase,
    @Nullable String helperRobot,
    ResponderPhase responderPhase,
    @Nullable String helpedRobot,
    double urge,
    String lastChange,
    @Nullable String holdReason)
    implements Reading {

  /** The status of a robot that is not held. */
  public RecruitmentStatus(
      Instant measured,
      RequesterPhase requester,
      @Nullable String helper,
      ResponderPhase responder,
      @Nullable String helped,
      double urge,
      String doing) {
    this(measured, requester, helper, responder, helped, urge, doing, null);
  }

  public RecruitmentStatus {
    if (!(urge >= 0 && urge <= 1)) {
      throw new IllegalArgumentException("urge " + urge + " is outside 0 to 1");
    }
  }
}
