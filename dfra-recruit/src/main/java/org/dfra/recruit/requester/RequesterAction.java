package org.dfra.recruit.requester;

import java.time.Duration;
import java.util.UUID;
import org.dfra.recruit.message.RecruitmentMessage;

/** An action of a requester. */
public sealed interface RequesterAction {

  /** Sends a message to one robot. */
  record SendToRobot(String robot, RecruitmentMessage message) implements RequesterAction {}

  /** Sends a message to all robots that can observe the percept. */
  record SendToTeam(String percept, RecruitmentMessage message) implements RequesterAction {}

  /** Accepts the lease of a robot that has arrived. */
  record AcceptLease(String robot, UUID lease, Duration stay) implements RequesterAction {}

  /** The recruitment is complete: the robot observes. */
  record Complete(String robot) implements RequesterAction {}

  /** Replaces a chosen robot: searches for another. */
  record ReplaceHelper(String robot, String why) implements RequesterAction {}

  /** The call has ended; {@code success} where it was complete. */
  record EndCall(boolean success, String why) implements RequesterAction {}
}
