package org.dfra.module;

import org.dfra.lifecycle.Readiness;

/** The requested data is not available yet, or no longer. */
public final class NotReadyException extends IllegalStateException {

  private static final long serialVersionUID = 1L;

  private final Readiness readiness;

  /**
   * @param module the module's path, {@code robot/name}
   * @param readiness its state at the time of the call
   * @param reason what is missing and what it waits for, as the rest of a sentence
   */
  public NotReadyException(String module, Readiness readiness, String reason) {
    super(module + " is " + readiness + ": " + reason);
    this.readiness = readiness;
  }

  /** The module's state at the time of the call. */
  public Readiness readiness() {
    return readiness;
  }
}
