package org.dfra.module;

/** The module was asked for something that it does not have yet, or no longer. */
public final class NotReadyException extends IllegalStateException {

  private static final long serialVersionUID = 1L;

  private final Readiness readiness;

  /**
   * @param module the module's path, {@code robot/name}
   * @param readiness the state it was in when asked
   * @param reason what is missing and what it waits for, as the rest of a sentence
   */
  public NotReadyException(String module, Readiness readiness, String reason) {
    super(module + " is " + readiness + ": " + reason);
    this.readiness = readiness;
  }

  /** The state the module was in when asked. */
  public Readiness readiness() {
    return readiness;
  }
}
