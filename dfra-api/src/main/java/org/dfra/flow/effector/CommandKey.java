package org.dfra.flow.effector;

import java.io.Serializable;
import java.util.Objects;
import java.util.UUID;

/**
 * What shows an effector that a command comes from its commander. It comes with the {@link
 * CommandLease} and ends with it; who knows it commands, so it is not shown around.
 *
 * @param secret drawn by lot for each lease
 */
public record CommandKey(UUID secret) implements Serializable {

  public CommandKey {
    Objects.requireNonNull(secret, "secret");
  }

  /** Without the secret. */
  @Override
  public String toString() {
    return "CommandKey";
  }
}
