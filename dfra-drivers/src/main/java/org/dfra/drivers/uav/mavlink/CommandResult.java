package org.dfra.drivers.uav.mavlink;

/**
 * What became of a command.
 *
 * @param outcome how it ended
 * @param code {@code MAV_RESULT} where it was answered, else 0
 */
record CommandResult(CommandOutcome outcome, int code) {

  /** How a command may end. */
  enum CommandOutcome {
    /** It is, or will be, done. */
    ACCEPTED,
    /** The vehicle will not do it. */
    REJECTED,
    /** Nothing came back, though it was sent several times; it may be done or not. */
    TIMED_OUT,
    /** The link was lost before an answer came; it may be done or not. */
    LINK_LOST
  }

  static final CommandResult UNANSWERED = new CommandResult(CommandOutcome.TIMED_OUT, 0);
  static final CommandResult LOST = new CommandResult(CommandOutcome.LINK_LOST, 0);

  /** {@code MAV_RESULT_IN_PROGRESS}: no end yet. */
  static final int IN_PROGRESS = 5;

  static CommandResult answered(int code) {
    return new CommandResult(code == 0 ? CommandOutcome.ACCEPTED : CommandOutcome.REJECTED, code);
  }

  boolean isAccepted() {
    return outcome == CommandOutcome.ACCEPTED;
  }

  /** Whether it is refused only as things are now. */
  boolean isTemporary() {
    return outcome == CommandOutcome.REJECTED && code == 1;
  }

  /** As the rest of a sentence that begins with the command's name. */
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
      case 7 -> "only taken as COMMAND_LONG";
      case 8 -> "only taken as COMMAND_INT";
      case 9 -> "not supported in this frame";
      default -> "refused with result " + code;
    };
  }
}
