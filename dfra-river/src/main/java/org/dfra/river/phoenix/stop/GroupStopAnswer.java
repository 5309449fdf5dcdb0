package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.Objects;

/**
 * What the virtual machine of a group answers to an order to stop.
 *
 * @param effectors what its effectors answered
 * @param others its active objects that are no effectors
 */
public record GroupStopAnswer(List<Stopped> effectors, List<ActivationID> others)
    implements Serializable {

  /** Of a group that has no process. */
  public static final GroupStopAnswer NONE = new GroupStopAnswer(List.of(), List.of());

  /**
   * One effector.
   *
   * @param object the activation ID of its server
   * @param stop what it answered
   */
  public record Stopped(ActivationID object, EffectorStop stop) implements Serializable {
    public Stopped {
      Objects.requireNonNull(object, "object");
      Objects.requireNonNull(stop, "stop");
    }
  }

  public GroupStopAnswer {
    effectors = List.copyOf(effectors);
    others = List.copyOf(others);
  }
}
