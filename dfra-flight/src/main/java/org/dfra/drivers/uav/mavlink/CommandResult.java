package org.dfra.drivers.uav.mavlink;

/**
 * The result of a command.
 *
 * @param outcome how it ended
 * @param code {@code MAV_RESULT} if it was acknowledged, else 0
 */
record CommandResult(CommandOutcome outcome, int code) {

  /** How a command can end. */
  enum CommandOutcome {
    /** It is, or will be, executed. */
    ACCEPTED,
    /** The vehicle rejected it. */
    REJECTED,
    /** No acknowledgement after several transmissions; it may have been executed or not. */
    TIMED_OUT,
    /** The link was lost before an acknowledgement; it may have been executed or not. */
    LINK_LOST
  }

  static final CommandResult UNANSWERED = new CommandResult(CommandOutcome.TIMED_OUT, 0);
  static final CommandResult LOST = new CommandResult(CommandOutcome.LINK_LOST, 0);

  /** {@code MAV_RESULT_IN_PROGRESS}: not ended yet. */
  static final int IN_PROGRESS = 5;

  static CommandResult answered(int code) {
    return new CommandResult(code == 0 ? CommandOutcome.ACCEPTED : CommandOutcome.REJECTED, code);
  }

  boolean isAccepted() {
    return outcome == CommandOutcome.ACCEPTED;
  }

  /** Whether the rejection is temporary. */
  boolean isTemporary() {
    return outcome == CommandOutcome.REJECTED && code == 1;
  }

  /** Completes a sentence that begins with the command's name. */
  @Override
  public String toString() {
    return switch (outcome) {
      case ACCEPTED -> "is accepted";
      case REJECTED -> "is " + word();
      case TIMED_OUT -> "was sent " + CommandProtocol.MOST + " times and is not answered";
      case LINK_LOST -> "was sent, and the link was lost before an answer came";
    };
  }

  private String word() {
    return switch (code) {
      case 1 -> "rejected for now";
      case 2 -> "denied";
      case 3 -> "not supported";
      case 4 -> "failed";
      case 6 -> "cancelled";
      case 7 -> "accepted only as COMMAND_LONG";
      case 8 -> "accepted only as COMMAND_INT";
      case 9 -> "not supported in this frame";
      default -> "refused with result " + code;
    };
  }
}
