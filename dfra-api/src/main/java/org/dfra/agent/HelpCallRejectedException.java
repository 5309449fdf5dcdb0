package org.dfra.agent;

/**
 * A call for help was rejected. The message says why, for people; {@link #reason} says it for
 * programs. Nothing was sent.
 */
public final class HelpCallRejectedException extends IllegalArgumentException {

  private static final long serialVersionUID = 1L;

  /** Why a call is rejected. */
  public enum Reason {
    /** The agent calls already, or has ended. */
    NOT_READY,
    /** The place is outside the field. */
    OUTSIDE_FIELD,
    /** The agent knows no other robot, or not yet. */
    ALONE,
    /** No robot within reach can observe the percept. */
    NO_CAPABLE_ROBOT,
    /** Only robots that share a name can observe the percept. */
    AMBIGUOUS_NAMES
  }

  private final Reason reason;

  public HelpCallRejectedException(Reason reason, String message) {
    super(message);
    this.reason = reason;
  }

  /** Why. */
  public Reason reason() {
    return reason;
  }
}
