package org.dfra.river.phoenix.stop;

import java.io.Serializable;
import java.util.Objects;
import java.util.UUID;
import org.dfra.flow.effector.EmergencyStopState;
import org.jspecify.annotations.Nullable;

/**
 * An effector's answer to a stop request.
 *
 * @param id the module's identity, its service ID in every lookup service
 * @param path the module's path, {@code robot/name}
 * @param wasStopped whether it was stopped before this request
 * @param state its present state; null if it did not answer
 * @param fault why it did not answer, a clause; null if it did
 */
public record EffectorStopResult(
    UUID id,
    String path,
    boolean wasStopped,
    @Nullable EmergencyStopState state,
    @Nullable String fault)
    implements Serializable {

  public EffectorStopResult {
    Objects.requireNonNull(id, "id");
    Objects.requireNonNull(path, "path");
    if ((state == null) == (fault == null)) {
      throw new IllegalArgumentException(
          path + " has both an answer and a fault, or neither; one of them is needed");
    }
  }

  /** Name of its robot. */
  public String robot() {
    int slash = path.indexOf('/');
    return slash < 0 ? "" : path.substring(0, slash);
  }

  /** Whether it executes no command, and its driver has stopped its device. */
  public boolean isConfirmed() {
    return state != null && state.latched() && state.haltCommanded();
  }
}
