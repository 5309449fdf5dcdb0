package org.dfra.recruit.requester;

import java.time.Duration;
import java.util.UUID;
import org.dfra.recruit.message.RecruitmentMessage;

/** What a requester does. */
public sealed interface RequesterAction {

  /** Tells one robot. */
  record SendToRobot(String robot, RecruitmentMessage message) implements RequesterAction {}

  /** Tells all that can observe the percept. */
  record SendToTeam(String percept, RecruitmentMessage message) implements RequesterAction {}

  /** Takes the lease of a robot that is there. */
  record AcceptLease(String robot, UUID lease, Duration stay) implements RequesterAction {}

  /** The recruitment is complete: the robot observes. */
  record Complete(String robot) implements RequesterAction {}

  /** A chosen robot was given up; another is looked for. */
  record ReplaceHelper(String robot, String why) implements RequesterAction {}

  /** The call has ended; {@code success} where it was complete. */
  record EndCall(boolean success, String why) implements RequesterAction {}
}
