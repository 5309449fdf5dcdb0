package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.util.Objects;

/**
 * A group that has, or may have, an effector that did not confirm its stop.
 *
 * @param robot name of its robot; empty for a group of no robot
 * @param group its name for people, {@code robot.group}
 * @param reason why it is unconfirmed, a clause
 */
public record UnconfirmedGroup(String robot, String group, String reason) implements Serializable {

  public UnconfirmedGroup {
    Objects.requireNonNull(robot, "robot");
    Objects.requireNonNull(group, "group");
    Objects.requireNonNull(reason, "reason");
  }
}
