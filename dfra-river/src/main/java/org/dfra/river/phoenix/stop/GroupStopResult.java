package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.Objects;

/**
 * What the virtual machine of a group answers to an order to stop.
 *
 * @param effectors what its effectors answered
 * @param otherObjects its active objects that are no effectors
 */
public record GroupStopResult(List<EffectorAnswer> effectors, List<ActivationID> otherObjects)
    implements Serializable {

  /** Of a group that has no process. */
  public static final GroupStopResult NONE = new GroupStopResult(List.of(), List.of());

  /**
   * One effector.
   *
   * @param object the activation ID of its server
   * @param stop what it answered
   */
  public record EffectorAnswer(ActivationID object, EffectorStopResult stop)
      implements Serializable {
    public EffectorAnswer {
      Objects.requireNonNull(object, "object");
      Objects.requireNonNull(stop, "stop");
    }
  }

  public GroupStopResult {
    effectors = List.copyOf(effectors);
    otherObjects = List.copyOf(otherObjects);
  }
}
