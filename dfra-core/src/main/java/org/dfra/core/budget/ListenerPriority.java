package org.dfra.core.budget;

import java.util.Locale;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;

/** Whose readings become fewer first when a radio's rate is reached: those of the first. */
public enum ListenerPriority {
  /** Strangers, and members with an expired certificate. */
  STRANGER,
  /** Observers. */
  OBSERVER,
  /** Other robots. */
  ROBOT,
  /** Operators, and the robot's own processes. */
  OPERATOR;

  /** The priority of a caller's listeners. */
  public static ListenerPriority of(Caller caller) {
    if (caller.standing() == Standing.OWN) {
      return OPERATOR;
    }
    if (caller.standing() != Standing.MEMBER) {
      return STRANGER;
    }
    return switch (caller.member().orElseThrow().role()) {
      case OBSERVER -> OBSERVER;
      case ROBOT -> ROBOT;
      case OPERATOR -> OPERATOR;
    };
  }

  /** In tables. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }
}
