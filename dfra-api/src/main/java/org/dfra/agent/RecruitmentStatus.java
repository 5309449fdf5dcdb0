package org.dfra.agent;

import java.time.Instant;
import org.dfra.event.Reading;
import org.jspecify.annotations.Nullable;

/**
 * What a recruitment agent is at; told whenever it changes.
 *
 * @param measured when it was so, by the robot's clock, UTC
 * @param requesterPhase what it is at as one that needs help
 * @param helperRobot the robot that it has chosen; null where it has chosen none
 * @param responderPhase what it is at as one that helps
 * @param helpedRobot the robot that it helps, or has offered to; null where there is none
 * @param urge how much it feels that it should help, 0 to 1; at 1 it does
 * @param lastChange what changed last, for people, as a clause
 * @param holdReason why its robot answers no call, since somebody stopped it and nobody let it go
 *     on, as a clause; null where it is not held
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

  /** Of a robot that nobody holds. */
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
