package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.Objects;

/**
 * The answer of a group's virtual machine to a stop request.
 *
 * @param effectors the answers of its effectors
 * @param otherObjects its active objects that are no effectors
 */
public record GroupStopResult(List<EffectorAnswer> effectors, List<ActivationID> otherObjects)
    implements Serializable {

  /** The answer of a group without a process. */
  public static final GroupStopResult NONE = new GroupStopResult(List.of(), List.of());

  /**
   * One effector.
   *
   * @param object the activation ID of its server
   * @param stop its answer
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
