package org.dfra.flow.effector;

import java.io.Serializable;
import java.util.Objects;
import java.util.UUID;

/**
 * The secret that authenticates a command as its commander's. It is issued with the {@link
 * CommandLease} and ends with it. Any client that knows it can command, so it must not be
 * disclosed.
 *
 * @param secret random for each lease
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
